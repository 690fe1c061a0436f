// SPDX-License-Identifier: MIT
#include "viewer/app/compare/picture_grid.h"

#include <algorithm>
#include <cmath>

#include "viewer/app/compare/vertex_distance.h"
#include "viewer/app/inspect/paint.h"

namespace sinew::viewer {
namespace {

std::uint8_t srgb_code(float linear) {
  const float encoded =
      linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;  // IEC 61966-2-1
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(encoded, 0.0f, 1.0f)));
}

}  // namespace

Picture picture_grid(std::span<const Picture> pictures, std::size_t columns) {
  if (pictures.empty() || columns == 0) return {};
  const std::uint32_t width = pictures[0].width, height = pictures[0].height;
  const auto wide = static_cast<std::uint32_t>(std::min(columns, pictures.size()));
  const auto high = static_cast<std::uint32_t>((pictures.size() + columns - 1) / columns);
  Picture grid{wide * (width + kGridGap) - kGridGap, high * (height + kGridGap) - kGridGap, {}};
  grid.rgba.assign(std::size_t{4} * grid.width * grid.height, 0);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::size_t left = (i % columns) * (width + kGridGap), top = (i / columns) * (height + kGridGap);
    for (std::uint32_t y = 0; y < height; ++y)
      std::copy_n(pictures[i].rgba.begin() + static_cast<std::ptrdiff_t>(std::size_t{4} * width * y),
                  std::size_t{4} * width,
                  grid.rgba.begin() + static_cast<std::ptrdiff_t>(4 * ((top + y) * grid.width + left)));
  }
  return grid;
}

Picture distance_scale(std::uint32_t width, std::uint32_t height) {
  constexpr std::uint8_t kDark = 32;
  Picture picture{width, height, {}};
  picture.rgba.resize(std::size_t{4} * width * height);
  const std::uint32_t left = width * 2 / 5, right = width * 3 / 5, top = height / 10, bottom = height - height / 10;
  for (std::uint32_t y = 0; y < height; ++y) {
    const double share = bottom > top + 1 ? static_cast<double>(bottom - 1 - std::clamp(y, top, bottom - 1)) /
                                                static_cast<double>(bottom - 1 - top)
                                          : 0.0;
    const glm::vec3 color = share_color(share);
    for (std::uint32_t x = 0; x < width; ++x) {
      const bool inside = x >= left && x < right && y >= top && y < bottom;
      std::uint8_t* pixel = &picture.rgba[4 * (std::size_t{width} * y + x)];
      for (int c = 0; c < 3; ++c) pixel[c] = inside ? srgb_code(color[c]) : kDark;
      pixel[3] = 255;
    }
  }
  return picture;
}

}  // namespace sinew::viewer
