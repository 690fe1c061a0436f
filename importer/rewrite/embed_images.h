// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Moves images from files and data URIs into buffer views, byte for byte whatever their kind. An image that had a
/// file name but no name gets the file's. A missing image is a loss ("image-missing") and keeps its URI.
void embed_images(const gltf::Document& document, Draft& draft);

/// The media type of an image by its first bytes (PNG, JPEG, WebP, KTX2, AVIF, DDS); `declared` where they tell
/// nothing.
std::string image_type(Bytes encoded, const std::string& declared);

}  // namespace sinew::rewrite
