// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "viewer/upload/texel_use.h"

namespace sinew::viewer {

struct MipLevel {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< or bytes of another format; the faces of a cube follow each other
};

/// Number of mip levels down to 1 x 1.
std::uint32_t mip_count(std::uint32_t width, std::uint32_t height) noexcept;

/// All mip levels of an image; level 0 is the image itself. Each texel is the mean of 2 x 2 texels of the level above;
/// an odd last row or column is dropped. sRGB colours are averaged in linear light. If alpha is coverage, it weights
/// the colours, so that colours of transparent texels do not bleed into edges. With an alpha test, each level keeps the
/// image's coverage (alpha_coverage.h).
/// in   rgba[4 * width * height], width and height at least 1
/// cost O(pixels)
std::vector<MipLevel> mip_chain(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height,
                                const TexelUse& use);

}  // namespace sinew::viewer
