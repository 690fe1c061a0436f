// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Moves images from files and data URIs into buffer views, byte for byte. An unnamed image gets the name of its file.
/// A missing image is a loss ("image-missing") and keeps its URI.
void embed_images(const gltf::Document& document, Draft& draft);

/// The media type of an image from its first bytes (PNG, JPEG, WebP, KTX2, AVIF, DDS); `declared` if unknown.
std::string image_type(Bytes encoded, const std::string& declared);

}  // namespace sinew::rewrite
