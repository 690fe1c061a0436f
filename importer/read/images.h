// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/file/document.h"
#include "importer/import_gltf.h"
#include "importer/issue_log.h"
#include "runtime/model/material.h"

namespace sinew {

/// Pixels of every image of the document, or what its header says alone (options.probe_images). One that is missing,
/// damaged or too large stays empty with its reason, and the rest of the file still loads (G66). in
/// options.max_image_pixels bounds all images together; each must also be plausible for its bytes, so that a few
///      bytes cannot ask for gigabytes (G68)
/// out  as many as document.images, in their order
/// warning image-missing.   cost O(pixels), spread over cores
std::vector<Image> read_images(const gltf::Document& document, const ImportOptions& options, IssueLog& log);

}  // namespace sinew
