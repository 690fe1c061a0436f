// SPDX-License-Identifier: MIT
#include "viewer/upload/rip_map.h"

#include <algorithm>

#include "viewer/upload/alpha_coverage.h"
#include "viewer/upload/srgb_codes.h"

namespace sinew::viewer {

namespace {

/// Colours in linear light, premultiplied by their weight if alpha is coverage.
struct Level {
  std::uint32_t width = 0, height = 0;
  std::vector<float> rgba;

  float& at(std::size_t x, std::size_t y, std::size_t channel) { return rgba[4 * (y * width + x) + channel]; }
  float at(std::size_t x, std::size_t y, std::size_t channel) const { return rgba[4 * (y * width + x) + channel]; }
};

Level level_of(std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<float>(std::size_t{4} * width * height)};
}

Level decoded(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, const TexelUse& use) {
  const SrgbCodes& codes = srgb_codes();
  Level level = level_of(width, height);
  for (std::size_t i = 0; i < level.rgba.size(); ++i) {
    const bool color = i % 4 < 3;
    level.rgba[i] = use.srgb && color ? codes.decode(rgba[i]) : static_cast<float>(rgba[i]) / 255.0f;
    if (use.alpha_covers && color) level.rgba[i] *= covered_weight(static_cast<float>(rgba[i | 3]) / 255.0f);
  }
  return level;
}

Level half_as_wide(const Level& from) {
  Level to = level_of(std::max(from.width / 2, 1u), from.height);
  for (std::size_t y = 0; y < to.height; ++y)
    for (std::size_t x = 0; x < to.width; ++x)
      for (std::size_t c = 0; c < 4; ++c) to.at(x, y, c) = 0.5f * (from.at(2 * x, y, c) + from.at(2 * x + 1, y, c));
  return to;
}

Level half_as_high(const Level& from) {
  Level to = level_of(from.width, std::max(from.height / 2, 1u));
  for (std::size_t y = 0; y < to.height; ++y)
    for (std::size_t x = 0; x < to.width; ++x)
      for (std::size_t c = 0; c < 4; ++c) to.at(x, y, c) = 0.5f * (from.at(x, 2 * y, c) + from.at(x, 2 * y + 1, c));
  return to;
}

MipLevel encoded(const Level& level, const TexelUse& use) {
  const SrgbCodes& codes = srgb_codes();
  MipLevel out{level.width, level.height, std::vector<std::uint8_t>(level.rgba.size())};
  for (std::size_t i = 0; i < out.rgba.size(); ++i) {
    const bool color = i % 4 < 3;
    float value = level.rgba[i];
    if (use.alpha_covers && color) value /= covered_weight(level.rgba[i | 3]);
    out.rgba[i] = use.srgb && color ? codes.encode(value) : static_cast<std::uint8_t>(value * 255.0f + 0.5f);
  }
  return out;
}

/// Writes a level into the image, with its corner at texel (x0, y0).
void store(const MipLevel& level, std::uint32_t x0, std::uint32_t y0, MipLevel& image) {
  for (std::size_t y = 0; y < level.height; ++y)
    std::copy_n(level.rgba.begin() + static_cast<std::ptrdiff_t>(4 * level.width * y), 4 * level.width,
                image.rgba.begin() + static_cast<std::ptrdiff_t>(4 * ((y0 + y) * image.width + x0)));
}

}  // namespace

MipLevel rip_map(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, const TexelUse& use) {
  MipLevel image{2 * width, 2 * height, std::vector<std::uint8_t>(std::size_t{16} * width * height)};
  MipLevel whole;
  Level full_width = decoded(rgba, width, height, use);
  for (std::uint32_t y = 0;; full_width = half_as_high(full_width)) {
    Level level = full_width;
    for (std::uint32_t x = 0;; level = half_as_wide(level)) {
      MipLevel texels = encoded(level, use);
      if (x + y == 0)
        whole = texels;
      else if (use.cutoff > 0)
        keep_coverage(whole, use.cutoff, texels);
      store(texels, x, y, image);
      if (level.width == 1) break;
      x = 2 * width - 2 * (level.width / 2);
    }
    if (full_width.height == 1) break;
    y = 2 * height - 2 * (full_width.height / 2);
  }
  return image;
}

}  // namespace sinew::viewer
