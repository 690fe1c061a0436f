// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "runtime/model/scene.h"

namespace sinew::reference {

/// eq   KHR_texture_transform: uv' = T(offset) * R(rotation) * S(scale) * uv. The rotation is counter-clockwise as the
///      image is seen, with v pointing down.
glm::dvec2 transformed(const TextureUse& use, const glm::dvec2& uv);

/// What a texture holds at transformed coordinates, 0 to 1 per channel, from the full image: textures that use mipmaps
/// are not known here. The filter is that of magnification.
/// in   srgb  colours are decoded, each texel before the filter
glm::dvec4 texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, bool srgb);

}  // namespace sinew::reference
