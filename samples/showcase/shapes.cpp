// SPDX-License-Identifier: MIT
#include "samples/showcase/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <tuple>

namespace sinew::showcase {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// For every vertex, the index of the first vertex at the same position.
std::vector<std::uint32_t> first_at_same_place(const std::vector<glm::vec3>& positions) {
  std::map<std::tuple<long, long, long>, std::uint32_t> seen;
  std::vector<std::uint32_t> first(positions.size());
  const auto quantised = [](float x) { return std::lround(static_cast<double>(x) * 1e5); };
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const auto& p = positions[i];
    first[i] = seen.try_emplace({quantised(p.x), quantised(p.y), quantised(p.z)}, i).first->second;
  }
  return first;
}

void set_bounds(Primitive& primitive) {
  primitive.bounds = {};
  for (const auto& p : primitive.positions) primitive.bounds.add(p);
}

}  // namespace

std::vector<glm::vec3> smooth_normals(const Primitive& primitive, const std::vector<glm::vec3>& positions) {
  const auto shared = first_at_same_place(primitive.positions);
  std::vector<glm::vec3> sums(positions.size(), glm::vec3(0.0f));
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::uint32_t a = primitive.indices[i], b = primitive.indices[i + 1], c = primitive.indices[i + 2];
    const glm::vec3 twice_area = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
    for (const std::uint32_t v : {a, b, c}) sums[shared[v]] += twice_area;
  }
  std::vector<glm::vec3> normals(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::vec3 sum = sums[shared[i]];
    const float length = glm::length(sum);
    normals[i] = length > 0.0f ? sum / length : glm::vec3(0.0f, 1.0f, 0.0f);
  }
  return normals;
}

Primitive grid(const Surface& surface, std::uint32_t columns, std::uint32_t rows) {
  Primitive out;
  for (std::uint32_t r = 0; r <= rows; ++r)
    for (std::uint32_t c = 0; c <= columns; ++c)
      out.positions.push_back(surface(static_cast<float>(c) / static_cast<float>(columns),
                                      static_cast<float>(r) / static_cast<float>(rows)));
  const std::uint32_t stride = columns + 1;
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t i = r * stride + c;
      out.indices.insert(out.indices.end(), {i, i + 1, i + stride + 1, i, i + stride + 1, i + stride});
    }
  out.normals = smooth_normals(out, out.positions);
  set_bounds(out);
  return out;
}

Primitive box(const glm::vec3& centre, const glm::vec3& half_size) {
  Primitive out;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      const int right = (axis + 1) % 3, up = (axis + 2) % 3;
      const auto first = static_cast<std::uint32_t>(out.positions.size());
      glm::vec3 normal(0.0f);
      normal[axis] = side;
      const std::array<glm::vec2, 4> counter_clockwise = {{{-1.0f, -1.0f}, {side, -side}, {1.0f, 1.0f}, {-side, side}}};
      for (const glm::vec2& xy : counter_clockwise) {
        glm::vec3 corner(0.0f);
        corner[axis] = side;
        corner[right] = xy.x;
        corner[up] = xy.y;
        out.positions.push_back(centre + half_size * corner);
        out.normals.push_back(normal);
      }
      out.indices.insert(out.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
  set_bounds(out);
  return out;
}

Primitive sphere(const glm::vec3& centre, float radius, std::uint32_t columns, std::uint32_t rows) {
  return grid(
      [&](float u, float v) {
        const float longitude = 2.0f * kPi * u, latitude = kPi * (v - 0.5f);
        return centre + radius * glm::vec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                           std::cos(latitude) * std::cos(longitude));
      },
      columns, rows);
}

Primitive lathe(const glm::vec3& base, float height, const std::function<float(float)>& radius, std::uint32_t columns,
                std::uint32_t rows) {
  // one extra row at each end closes the solid
  return grid(
      [&](float u, float v) {
        const float row = std::round(v * static_cast<float>(rows + 2));
        const float along = std::min(std::max((row - 1.0f) / static_cast<float>(rows), 0.0f), 1.0f);
        const bool cap = row < 0.5f || row > static_cast<float>(rows) + 1.5f;
        const float r = cap ? 0.0f : radius(along);
        const float angle = 2.0f * kPi * u;
        return base + glm::vec3(r * std::sin(angle), along * height, r * std::cos(angle));
      },
      columns, rows + 2);
}

void append(Primitive& whole, const Primitive& part) {
  const auto offset = static_cast<std::uint32_t>(whole.positions.size());
  whole.positions.insert(whole.positions.end(), part.positions.begin(), part.positions.end());
  whole.normals.insert(whole.normals.end(), part.normals.begin(), part.normals.end());
  whole.colors.insert(whole.colors.end(), part.colors.begin(), part.colors.end());
  for (const std::uint32_t i : part.indices) whole.indices.push_back(offset + i);
  set_bounds(whole);
}

}  // namespace sinew::showcase
