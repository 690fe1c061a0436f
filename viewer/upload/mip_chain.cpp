// SPDX-License-Identifier: MIT
#include "viewer/upload/mip_chain.h"

#include <algorithm>
#include <array>
#include <bit>

#include "viewer/upload/alpha_coverage.h"
#include "viewer/upload/srgb_codes.h"

namespace sinew::viewer {

namespace {

using Block = std::array<std::size_t, 4>;  // indices of the four texels that are averaged

/// Weight of each texel in the block's colour.
std::array<float, 4> shares(const MipLevel& from, const Block& block, const TexelUse& use) noexcept {
  if (!use.alpha_covers) return {0.25f, 0.25f, 0.25f, 0.25f};
  std::array<float, 4> share{};
  float sum = 0.0f;
  for (std::size_t i = 0; i < 4; ++i)
    sum += share[i] = covered_weight(static_cast<float>(from.rgba[4 * block[i] + 3]) / 255.0f);
  for (float& s : share) s /= sum;
  return share;
}

/// Writes the averaged texel of a block.
void average(const MipLevel& from, const Block& block, const TexelUse& use, std::uint8_t* out) {
  const SrgbCodes& codes = srgb_codes();
  const std::array<float, 4> share = shares(from, block, use);
  for (std::size_t channel = 0; channel < 4; ++channel) {
    if (use.srgb && channel < 3) {
      float sum = 0.0f;
      for (std::size_t i = 0; i < 4; ++i) sum += share[i] * codes.decode(from.rgba[4 * block[i] + channel]);
      out[channel] = codes.encode(sum);
    } else {
      unsigned sum = 2;  // rounds to nearest
      for (const std::size_t texel : block) sum += from.rgba[4 * texel + channel];
      out[channel] = static_cast<std::uint8_t>(sum / 4);
    }
  }
}

MipLevel halved(const MipLevel& from, const TexelUse& use) {
  MipLevel to;
  to.width = std::max(from.width / 2, 1u);
  to.height = std::max(from.height / 2, 1u);
  to.rgba.resize(std::size_t{4} * to.width * to.height);
  for (std::uint32_t y = 0; y < to.height; ++y) {
    const std::size_t y0 = 2 * y, y1 = std::min(2 * y + 1, from.height - 1);
    for (std::uint32_t x = 0; x < to.width; ++x) {
      const std::size_t x0 = 2 * x, x1 = std::min(2 * x + 1, from.width - 1);
      const Block block = {y0 * from.width + x0, y0 * from.width + x1, y1 * from.width + x0, y1 * from.width + x1};
      average(from, block, use, &to.rgba[4 * (std::size_t{y} * to.width + x)]);
    }
  }
  return to;
}

}  // namespace

std::uint32_t mip_count(std::uint32_t width, std::uint32_t height) noexcept {
  return static_cast<std::uint32_t>(std::bit_width(std::max(width, height)));
}

std::vector<MipLevel> mip_chain(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height,
                                const TexelUse& use) {
  std::vector<MipLevel> levels;
  levels.reserve(mip_count(width, height));
  levels.push_back({width, height, {rgba.begin(), rgba.end()}});
  while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back(), use));
  // In a second pass, because each level must be averaged from unscaled alpha.
  for (std::size_t i = 1; use.cutoff > 0 && i < levels.size(); ++i) keep_coverage(levels[0], use.cutoff, levels[i]);
  return levels;
}

}  // namespace sinew::viewer
