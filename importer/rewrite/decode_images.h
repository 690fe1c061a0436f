// SPDX-License-Identifier: MIT
#pragma once
#include "importer/rewrite/draft.h"

namespace sinew::rewrite {

/// Replaces WebP, AVIF and KTX2 images by PNG images of their largest level. Their textures name them as `source`, and
/// the extensions EXT_texture_webp, EXT_texture_avif and KHR_texture_basisu go. An image that cannot be decoded stays
/// as it is, and is a loss ("image-missing").
/// in     draft   after embed_images()
/// cost   O(pixels)
void decode_images(const gltf::Document& document, Draft& draft);

}  // namespace sinew::rewrite
