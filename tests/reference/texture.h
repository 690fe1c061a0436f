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

/// Colour of a texture at transformed coordinates, 0 to 1 per channel, read from the full image with the magnification
/// filter. A sampler without mipmaps shows this however small the image appears.
/// in   srgb  each texel is decoded before filtering
glm::dvec4 texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, bool srgb);

/// The mip level for a footprint.
/// eq   log2 of the texels from one pixel to the next, along the row or the column of pixels, whichever has more; 0 for
///      less than a texel, at most floor(log2 of the larger side of the image)
double mip_level(const Scene& scene, const TextureUse& use, double texels);

/// Colour of a mipmap at a level. A texel of level i is the mean of 2^i x 2^i texels of the image (or of the whole side
/// where it is shorter). Four texels are mixed bilinearly, and two levels by the fraction of the level.
glm::dvec4 mip_texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, double level, bool srgb);

/// Mean of texels whose alpha is coverage: alpha weights the colours. If all are transparent, the weights are equal.
glm::dvec4 covered_mean(std::span<const glm::dvec4> texels);

/// Share of an image that an alpha test keeps. Each texel is tested at four points, a quarter of a texel from its
/// middle. Each point is interpolated from four texels, with edges clamped.
/// in   rgba[4 * width * height];   cutoff  least alpha that is kept, 0 to 255
double kept_share(std::span<const std::uint8_t> rgba, int width, int height, double cutoff);

/// Levels of a rip map along u and v for a footprint.
/// eq   log2 of its side, in texels; 0 for less than a texel, at most floor(log2 of the texels of the image)
glm::dvec2 rip_levels(const Scene& scene, const TextureUse& use, const glm::dvec2& texels);

/// Colour of a rip map. Texel (x, y) of level (i, j) is the mean of 2^i x 2^j texels of the image. Four texels are
/// mixed bilinearly, and four levels by the fractions of the two levels.
/// in   texels  sides of the footprint along u and v, in texels of the image
glm::dvec4 rip_texel(const Scene& scene, const TextureUse& use, const glm::dvec2& uv, const glm::dvec2& texels,
                     bool srgb);

}  // namespace sinew::reference
