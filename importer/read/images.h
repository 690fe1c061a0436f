// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/file/document.h"
#include "importer/import_gltf.h"
#include "importer/issue_log.h"
#include "runtime/model/material.h"

namespace sinew {

/// Decodes every image of the document, or reads only the headers (options.probe_images). An image that is missing,
/// damaged or too large stays empty and says why; the rest of the file still loads (G66).
/// in       options.max_image_pixels bounds the pixels of all images together. The size of each image must also be
///          plausible for its bytes, so that a few bytes cannot ask for gigabytes (G68)
/// out      one entry for each of document.images, in their order
/// warning  image-missing
/// cost     O(pixels), spread over all cores
/// Images with the same bytes, such as many entries on one view, are decoded once: textures use the first of them, and
/// the others stay empty with that reason.
/// in,out   textures   of the document; their images count in document.images
std::vector<Image> read_images(const gltf::Document& document, const ImportOptions& options,
                               std::vector<Texture>& textures, IssueLog& log);

}  // namespace sinew
