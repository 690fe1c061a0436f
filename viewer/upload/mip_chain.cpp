// SPDX-License-Identifier: MIT
#include "viewer/upload/mip_chain.h"

#include <algorithm>
#include <array>
#include <bit>

#include "viewer/upload/srgb_codes.h"

namespace sinew::viewer {

namespace {

MipLevel halved(const MipLevel& from, bool srgb) {
  const SrgbCodes& codes = srgb_codes();
  MipLevel to;
  to.width = std::max(from.width / 2, 1u);
  to.height = std::max(from.height / 2, 1u);
  to.rgba.resize(std::size_t{4} * to.width * to.height);
  for (std::uint32_t y = 0; y < to.height; ++y) {
    const std::size_t y0 = 2 * y, y1 = std::min(2 * y + 1, from.height - 1);
    for (std::uint32_t x = 0; x < to.width; ++x) {
      const std::size_t x0 = 2 * x, x1 = std::min(2 * x + 1, from.width - 1);
      const std::array<std::size_t, 4> texels = {y0 * from.width + x0, y0 * from.width + x1, y1 * from.width + x0,
                                                 y1 * from.width + x1};
      for (std::size_t channel = 0; channel < 4; ++channel) {
        std::uint8_t& out = to.rgba[4 * (std::size_t{y} * to.width + x) + channel];
        if (srgb && channel < 3) {
          float sum = 0.0f;
          for (const std::size_t texel : texels) sum += codes.decode(from.rgba[4 * texel + channel]);
          out = codes.encode(0.25f * sum);
        } else {
          unsigned sum = 2;  // rounds to nearest
          for (const std::size_t texel : texels) sum += from.rgba[4 * texel + channel];
          out = static_cast<std::uint8_t>(sum / 4);
        }
      }
    }
  }
  return to;
}

}  // namespace

std::uint32_t mip_count(std::uint32_t width, std::uint32_t height) noexcept {
  return static_cast<std::uint32_t>(std::bit_width(std::max(width, height)));
}

std::vector<MipLevel> mip_chain(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height,
                                bool srgb) {
  std::vector<MipLevel> levels;
  levels.reserve(mip_count(width, height));
  levels.push_back({width, height, {rgba.begin(), rgba.end()}});
  while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back(), srgb));
  return levels;
}

}  // namespace sinew::viewer
