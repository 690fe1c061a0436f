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

/// Levels of a rip map along u and v that a footprint asks for.
/// eq   log2 of its side, in texels; 0 for less than a texel, at most floor(log2 of the texels of the image)
glm::dvec2 rip_levels(const Scene& scene, const TextureUse& use, const glm::dvec2& texels);

/// What a rip map of the texture holds: texel (x, y) of level (i, j) is the mean of 2^i x 2^j texels of the image, four
/// of them are mixed, and four levels by the fractions of the levels.
/// in   texels  sides of the footprint along u and v, in texels of the image
glm::dvec4 rip_texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, const glm::dvec2& texels,
                     bool srgb);

}  // namespace sinew::reference
