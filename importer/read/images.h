// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/file/document.h"
#include "importer/import_gltf.h"
#include "importer/issue_log.h"
#include "runtime/model/material.h"

namespace sinew {

/// Decodes every image of the document, or reads only the headers (options.probe_images). A missing, damaged or too
/// large image stays empty, with a reason; the rest of the file still loads. Images with identical bytes, such as
/// several entries of one view, are decoded once. Textures are redirected to the first; the others stay empty, with
/// that reason.
/// in       options.max_image_pixels limits the pixels of all images together. The size of each image must also be
///          plausible for its bytes
/// in,out   textures   of the document, with indices into document.images
/// out      one entry for each of document.images, in their order
/// warning  image-missing
/// cost     O(pixels), spread over all cores
std::vector<Image> read_images(const gltf::Document& document, const ImportOptions& options,
                               std::vector<Texture>& textures, IssueLog& log);

/// Decodes one image under the same limits.
/// in,out   pixels_left   pixels that further images may have
/// err      the reason, a message for users
tl::expected<Image, std::string> read_image(std::span<const std::byte> encoded, std::uint64_t& pixels_left);

}  // namespace sinew
