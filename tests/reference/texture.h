// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "runtime/model/scene.h"

namespace sinew::reference {

/// eq   KHR_texture_transform: uv' = T(offset) * R(rotation) * S(scale) * uv. The rotation is counter-clockwise as the
///      image is seen, with v pointing down.
glm::dvec2 transformed(const TextureUse& use, const glm::dvec2& uv);

/// What a texture holds at transformed coordinates, 0 to 1 per channel, from the full image, by the filter of
/// magnification: where a footprint is larger than a texel, this is what a sampler without mipmaps shows.
/// in   srgb  colours are decoded, each texel before the filter
glm::dvec4 texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, bool srgb);

/// The level of a mipmap that a footprint asks for.
/// eq   log2 of the texels from one pixel to the next, along the row or the column of pixels where they are more; 0 for
///      less than a texel, at most floor(log2 of the larger side of the image)
double mip_level(const Scene& scene, const TextureUse& use, double texels);

/// What a mipmap of the texture holds at a level: a texel of level i is the mean of 2^i x 2^i texels of the image,
/// along a side that has fewer of all, four of them are mixed, and two levels by the fraction of the level.
glm::dvec4 mip_texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, double level, bool srgb);

/// Mean of texels whose alpha is coverage: colours count by it; where nothing covers, all alike.
glm::dvec4 covered_mean(std::span<const glm::dvec4> texels);

/// Share of an image that an alpha test keeps: of four points a texel, a quarter of a texel from its middle, mixed from
/// four texels; edges are clamped.
/// in   rgba[4 * width * height];   cutoff  least alpha that is kept, 0 to 255
double kept_share(std::span<const std::uint8_t> rgba, int width, int height, double cutoff);

/// Levels of a rip map along u and v that a footprint asks for.
/// eq   log2 of its side, in texels; 0 for less than a texel, at most floor(log2 of the texels of the image)
glm::dvec2 rip_levels(const Scene& scene, const TextureUse& use, const glm::dvec2& texels);

/// What a rip map of the texture holds: texel (x, y) of level (i, j) is the mean of 2^i x 2^j texels of the image, four
/// of them are mixed, and four levels by the fractions of the levels.
/// in   texels  sides of the footprint along u and v, in texels of the image
glm::dvec4 rip_texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, const glm::dvec2& texels,
                     bool srgb);

}  // namespace sinew::reference
