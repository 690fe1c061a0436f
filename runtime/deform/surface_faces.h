// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// The triangles of a mesh whose vertices come from elsewhere (a geometry cache), prepared for normals and tangents
/// that follow the vertices.
struct SurfaceFaces {
  std::vector<std::uint32_t> corners;  ///< [3T] vertices of the triangles
  /// [V] Vertices with equal rest position and rest normal are one point. Normals are thus smooth over texture seams
  /// and sharp at sharp edges.
  std::vector<std::uint32_t> point_of_vertex;
  std::uint32_t point_count = 0;  ///< points are numbered in the order of their first vertices
  /// [3T] or empty. Each corner's rest tangent in coordinates along the edges b - a and c - a of its triangle, times
  /// the length of their cross product.
  std::vector<glm::vec2> tangents;

  std::size_t count() const noexcept { return corners.size() / 3; }
};

/// Checks that corners form triangles and are below `vertex_count`, and that points are below point_count.
/// err  size_mismatch, index_out_of_range     cost O(V + T)
ErrorCode check_indices(const SurfaceFaces& faces, std::size_t vertex_count) noexcept;

/// in   primitive     of triangles;   with_tangents  if the primitive has tangents
/// cost O(V log V + T), allocates
SurfaceFaces join_surface(const Primitive& primitive, bool with_tangents);

}  // namespace sinew
