// SPDX-License-Identifier: MIT
#include "viewer/light/panorama.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "runtime/math/interpolate.h"

namespace sinew::viewer {
namespace {

/// Bilinear lookup in a direction; columns wrap around at the seam at -x.
glm::vec3 sample(const Panorama& panorama, const glm::vec3& direction) {
  const glm::vec3 d = glm::normalize(direction);
  const float turn = std::atan2(d.z, d.x) / (2.0f * std::numbers::pi_v<float>)+0.5f;
  const float fall = std::acos(std::clamp(d.y, -1.0f, 1.0f)) / std::numbers::pi_v<float>;
  const float x = turn * static_cast<float>(panorama.width) - 0.5f,
              y = std::clamp(fall * static_cast<float>(panorama.height) - 0.5f, 0.0f,
                             static_cast<float>(panorama.height - 1));
  const float left = std::floor(x);
  const auto column = [&](float at) {
    const auto wide = static_cast<std::int64_t>(panorama.width);
    return static_cast<std::size_t>((static_cast<std::int64_t>(at) + wide) % wide);
  };
  const auto above = static_cast<std::uint32_t>(y), below = std::min(above + 1, panorama.height - 1);
  const auto row = [&](std::uint32_t at) {
    const glm::vec3* texels = &panorama.texels[std::size_t{at} * panorama.width];
    return lerp(texels[column(left)], texels[column(left + 1.0f)], x - left);
  };
  return lerp(row(above), row(below), y - static_cast<float>(above));
}

}  // namespace

CubeMap cube_from(const Panorama& panorama, std::uint32_t size) {
  // Four faces span the horizon. Each cube texel takes as many samples as the panorama has texels in its width.
  const std::uint32_t across = (panorama.width + 4 * size - 1) / (4 * size), fine = size * across;
  CubeMap cube{size, {}};
  cube.texels.reserve(std::size_t{kCubeFaces} * size * size);
  for (std::uint32_t face = 0; face < kCubeFaces; ++face)
    for (std::uint32_t y = 0; y < size; ++y)
      for (std::uint32_t x = 0; x < size; ++x) {
        glm::vec3 sum(0.0f);
        for (std::uint32_t i = 0; i < across * across; ++i)
          sum += sample(panorama, texel_direction(face, x * across + i % across, y * across + i / across, fine));
        cube.texels.push_back(sum / static_cast<float>(across * across));
      }
  return cube;
}

}  // namespace sinew::viewer
