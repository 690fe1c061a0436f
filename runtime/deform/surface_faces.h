// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// The triangles of a mesh whose vertices move by themselves, prepared for normals and tangents that follow them.
struct SurfaceFaces {
  std::vector<std::uint32_t> corners;          ///< [3T] vertices of the triangles
  std::vector<std::uint32_t> point_of_vertex;  ///< [V] vertices with one position and one normal at rest are one point,
                                               ///< so normals are smooth over seams of texture and sharp at sharp edges
  std::uint32_t point_count = 0;               ///< points are numbered in the order of their first vertices
  std::vector<glm::vec2> tangents;  ///< [3T] or empty; each corner's tangent at rest along the edges b - a and c - a of
                                    ///< its triangle, times the length of their cross product

  std::size_t count() const noexcept { return corners.size() / 3; }
};

/// Every corner is below `vertex_count`, every point below the number of points, and the corners form triangles.
/// err  size_mismatch, index_out_of_range     cost O(V + T)
ErrorCode check_indices(const SurfaceFaces& faces, std::size_t vertex_count) noexcept;

/// in   primitive     of triangles;   with_tangents  where the primitive has some
/// cost O(V log V + T), allocates
SurfaceFaces join_surface(const Primitive& primitive, bool with_tangents);

}  // namespace sinew
