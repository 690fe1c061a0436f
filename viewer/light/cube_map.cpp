// SPDX-License-Identifier: MIT
#include "viewer/light/cube_map.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "runtime/math/interpolate.h"

namespace sinew::viewer {
namespace {

struct FacePoint {
  std::uint32_t face = 0;
  float u = 0.0f, v = 0.0f;
};

FacePoint face_point(const glm::vec3& d) noexcept {
  const glm::vec3 size = glm::abs(d);
  if (size.x >= size.y && size.x >= size.z)
    return d.x > 0.0f ? FacePoint{0, -d.z / size.x, -d.y / size.x} : FacePoint{1, d.z / size.x, -d.y / size.x};
  if (size.y >= size.z)
    return d.y > 0.0f ? FacePoint{2, d.x / size.y, d.z / size.y} : FacePoint{3, d.x / size.y, -d.z / size.y};
  return d.z > 0.0f ? FacePoint{4, d.x / size.z, -d.y / size.z} : FacePoint{5, -d.x / size.z, -d.y / size.z};
}

/// Center of texel i on its face, as a coordinate in [-1, 1].
float texel_middle(std::uint32_t i, std::uint32_t size) noexcept {
  return 2.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(size) - 1.0f;
}

/// Two neighbouring texels, and the weight of the second.
struct Between {
  std::uint32_t first = 0, second = 0;
  float share = 0.0f;
};

Between between(float position, std::uint32_t size) noexcept {
  const float last = static_cast<float>(size - 1);
  const float at = std::clamp((position + 1.0f) * 0.5f * static_cast<float>(size) - 0.5f, 0.0f, last);
  const auto first = static_cast<std::uint32_t>(at);
  return {first, std::min(first + 1, size - 1), at - static_cast<float>(first)};
}

}  // namespace

glm::vec3 face_direction(std::uint32_t face, float u, float v) noexcept {
  switch (face) {
    case 0: return {1.0f, -v, -u};
    case 1: return {-1.0f, -v, u};
    case 2: return {u, 1.0f, v};
    case 3: return {u, -1.0f, -v};
    case 4: return {u, -v, 1.0f};
    default: return {-u, -v, -1.0f};
  }
}

glm::vec3 texel_direction(std::uint32_t face, std::uint32_t x, std::uint32_t y, std::uint32_t size) noexcept {
  return glm::normalize(face_direction(face, texel_middle(x, size), texel_middle(y, size)));
}

float texel_solid_angle(std::uint32_t x, std::uint32_t y, std::uint32_t size) noexcept {
  const float u = texel_middle(x, size), v = texel_middle(y, size), edge = 2.0f / static_cast<float>(size);
  const float distance2 = 1.0f + u * u + v * v;
  return edge * edge / (distance2 * std::sqrt(distance2));
}

CubeMap halved(const CubeMap& cube) {
  const std::uint32_t size = cube.size / 2;
  CubeMap half{size, {}};
  half.texels.reserve(std::size_t{kCubeFaces} * size * size);
  for (std::uint32_t face = 0; face < kCubeFaces; ++face)
    for (std::uint32_t y = 0; y < size; ++y)
      for (std::uint32_t x = 0; x < size; ++x) {
        const glm::vec3* corner = &cube.texels[(std::size_t{face} * cube.size + 2 * y) * cube.size + 2 * x];
        half.texels.push_back(0.25f * (corner[0] + corner[1] + corner[cube.size] + corner[cube.size + 1]));
      }
  return half;
}

glm::vec3 sample(const CubeMap& cube, const glm::vec3& direction) noexcept {
  const FacePoint point = face_point(direction);
  const Between x = between(point.u, cube.size), y = between(point.v, cube.size);
  const glm::vec3* face = &cube.texels[std::size_t{point.face} * cube.size * cube.size];
  const glm::vec3 *above = face + std::size_t{y.first} * cube.size, *below = face + std::size_t{y.second} * cube.size;
  const glm::vec3 upper = lerp(above[x.first], above[x.second], x.share);
  return lerp(upper, lerp(below[x.first], below[x.second], x.share), y.share);
}

}  // namespace sinew::viewer
