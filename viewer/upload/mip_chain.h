// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace sinew::viewer {

struct MipLevel {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Number of levels down to 1 x 1.
std::uint32_t mip_count(std::uint32_t width, std::uint32_t height) noexcept;

/// All levels of an image, the first being the image itself. Each texel is the mean of the 2 x 2 texels above it (the
/// last row or column of an odd size is averaged with itself), taken in linear light when the colours are sRGB; alpha
/// is linear. in   rgba[4 * width * height], width and height at least 1;   cost O(pixels)
std::vector<MipLevel> mip_chain(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height,
                                bool srgb);

}  // namespace sinew::viewer
