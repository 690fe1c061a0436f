// SPDX-License-Identifier: MIT
#include "runtime/deform/surface_faces.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <span>

#include "runtime/math/conventions.h"

namespace sinew {
namespace {

/// Order by the bits of position and normal, so that equal vertices are neighbours.
int compare(const Primitive& primitive, std::uint32_t a, std::uint32_t b) {
  const int by_position = std::memcmp(&primitive.positions[a], &primitive.positions[b], sizeof(glm::vec3));
  if (by_position != 0 || primitive.normals.empty()) return by_position;
  return std::memcmp(&primitive.normals[a], &primitive.normals[b], sizeof(glm::vec3));
}

void join_points(const Primitive& primitive, SurfaceFaces& faces) {
  std::vector<std::uint32_t> order(primitive.vertex_count());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const int by_bits = compare(primitive, a, b);
    return by_bits != 0 ? by_bits < 0 : a < b;
  });
  // Points are numbered by their first vertex, so that sums of neighbours lie together.
  std::vector<std::uint32_t> first_of(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    first_of[order[k]] = k > 0 && compare(primitive, order[k - 1], order[k]) == 0 ? first_of[order[k - 1]] : order[k];
  faces.point_of_vertex.resize(order.size());
  for (std::uint32_t v = 0; v < order.size(); ++v)
    faces.point_of_vertex[v] = first_of[v] == v ? faces.point_count++ : faces.point_of_vertex[first_of[v]];
}

/// eq   t = x (b - a) + y (c - a) in the plane of the triangle, by the reciprocal basis;  (x, y) |n|, n the cross
/// product
glm::vec2 along_edges(const Vec3<double>& t, const Vec3<double>& ab, const Vec3<double>& ac) {
  const Vec3<double> n = glm::cross(ab, ac);
  const double length = glm::length(n);
  if (!(length > 0.0)) return glm::vec2(0.0f);
  return glm::vec2(Vec2<double>(glm::dot(glm::cross(t, ac), n), glm::dot(glm::cross(ab, t), n)) / length);
}

}  // namespace

SurfaceFaces join_surface(const Primitive& primitive, bool with_tangents) {
  SurfaceFaces faces;
  faces.corners = primitive.indices;
  join_points(primitive, faces);
  if (!with_tangents || primitive.tangents.empty()) return faces;
  for (std::size_t i = 0; i < faces.corners.size(); ++i) {
    const std::uint32_t* const triangle = &faces.corners[i / 3 * 3];
    const Vec3<double> a(primitive.positions[triangle[0]]), b(primitive.positions[triangle[1]]),
        c(primitive.positions[triangle[2]]);
    faces.tangents.push_back(along_edges(Vec3<double>(primitive.tangents[faces.corners[i]]), b - a, c - a));
  }
  return faces;
}

ErrorCode check_indices(const SurfaceFaces& faces, std::size_t vertex_count) noexcept {
  if (faces.corners.size() % 3 != 0) return ErrorCode::size_mismatch;
  const auto all_below = [](std::span<const std::uint32_t> indices, std::size_t limit) {
    return std::all_of(indices.begin(), indices.end(), [limit](std::uint32_t i) { return i < limit; });
  };
  const bool inside = all_below(faces.corners, vertex_count) && all_below(faces.point_of_vertex, faces.point_count);
  return inside ? ErrorCode::ok : ErrorCode::index_out_of_range;
}

}  // namespace sinew
