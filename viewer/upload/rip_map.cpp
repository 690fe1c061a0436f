// SPDX-License-Identifier: MIT
#include "viewer/upload/rip_map.h"

#include <algorithm>

#include "viewer/upload/srgb_codes.h"

namespace sinew::viewer {

namespace {

/// Colours in linear light.
struct Level {
  std::uint32_t width = 0, height = 0;
  std::vector<float> rgba;

  float& at(std::size_t x, std::size_t y, std::size_t channel) { return rgba[4 * (y * width + x) + channel]; }
  float at(std::size_t x, std::size_t y, std::size_t channel) const { return rgba[4 * (y * width + x) + channel]; }
};

Level level_of(std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<float>(std::size_t{4} * width * height)};
}

Level decoded(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, bool srgb) {
  const SrgbCodes& codes = srgb_codes();
  Level level = level_of(width, height);
  for (std::size_t i = 0; i < level.rgba.size(); ++i)
    level.rgba[i] = srgb && i % 4 < 3 ? codes.decode(rgba[i]) : static_cast<float>(rgba[i]) / 255.0f;
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

/// Writes the level into the image from texel (x0, y0) on.
void store(const Level& level, std::uint32_t x0, std::uint32_t y0, bool srgb, MipLevel& image) {
  const SrgbCodes& codes = srgb_codes();
  for (std::size_t y = 0; y < level.height; ++y)
    for (std::size_t x = 0; x < level.width; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        const float value = level.at(x, y, c);
        image.rgba[4 * ((y0 + y) * image.width + x0 + x) + c] =
            srgb && c < 3 ? codes.encode(value) : static_cast<std::uint8_t>(value * 255.0f + 0.5f);
      }
}

}  // namespace

MipLevel rip_map(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, bool srgb) {
  MipLevel image{2 * width, 2 * height, std::vector<std::uint8_t>(std::size_t{16} * width * height)};
  Level full_width = decoded(rgba, width, height, srgb);
  for (std::uint32_t y = 0;; full_width = half_as_high(full_width)) {
    Level level = full_width;
    for (std::uint32_t x = 0;; level = half_as_wide(level)) {
      store(level, x, y, srgb, image);
      if (level.width == 1) break;
      x = 2 * width - 2 * (level.width / 2);
    }
    if (full_width.height == 1) break;
    y = 2 * height - 2 * (full_width.height / 2);
  }
  return image;
}

}  // namespace sinew::viewer
