// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// The triangles of a mesh whose vertices come from a geometry cache. They are prepared so that normals and tangents
/// can follow the vertices.
struct SurfaceFaces {
  std::vector<std::uint32_t> corners;  ///< [3T] vertices of the triangles
  /// [V] Vertices with equal rest position and equal rest normal share a point. Normals are thus smooth across texture
  /// seams and sharp at sharp edges.
  std::vector<std::uint32_t> point_of_vertex;
  std::uint32_t point_count = 0;  ///< points are numbered in the order of their first vertices
  /// [3T] or empty. For SurfaceTangentsJob: the rest tangent of each corner, as coordinates along the rest edges b - a
  /// and c - a of its triangle. They are multiplied by the length of the edges' cross product, so that sums at a vertex
  /// weight triangles by area at rest.
  std::vector<glm::vec2> tangents;

  std::size_t count() const noexcept { return corners.size() / 3; }
};

/// Checks that corners form triangles and are below `vertex_count`, and that points are below point_count.
/// err  size_mismatch, index_out_of_range     cost O(V + T)
SINEW_API ErrorCode check_indices(const SurfaceFaces& faces, std::size_t vertex_count) noexcept;

/// in   primitive     of triangles;   with_tangents  if the primitive has tangents
/// cost O(V log V + T), allocates
SINEW_API SurfaceFaces join_surface(const Primitive& primitive, bool with_tangents);

/// Elements of SurfaceNormalsJob::sums: one per point, rounded up to tiles of 16.
constexpr std::size_t surface_sums(const SurfaceFaces& faces) noexcept {
  return (std::size_t{faces.point_count} + 15) / 16 * 16;
}

/// Smooth normals of a surface from its positions alone.
/// eq   n = normalise(sum of (b - a) x (c - a) over the triangles at a point), negated when `turned`
///      The sum weights triangles by area. It does not depend on how the ring around the point is cut into triangles.
///      Small triangles, which the quantisation step of a geometry cache disturbs most, count least.
/// in   faces        of the mesh (join_surface);   positions[V];   turned  true: the skin mirrors, so windings are
///      reversed
///      rest_normals[V]  kept by points without area
///      sums[surface_sums(faces)]  scratch
/// out  normals[V]   unit, from float edges and sums. For edges of 1e-9 to 1e9 m the error in radians is at most 8 u
///      sum |b - a| |c - a| / |sum of the cross products|, u = 2^-24
/// err  size_mismatch, index_out_of_range     cost O(V + T), no allocation
struct SurfaceNormalsJob {
  const SurfaceFaces* faces = nullptr;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> rest_normals;
  bool turned = false;
  std::span<glm::vec4> sums;
  std::span<glm::vec3> normals;
};
SINEW_API ErrorCode check(const SurfaceNormalsJob& job) noexcept;
SINEW_API void run_unchecked(const SurfaceNormalsJob& job) noexcept;

/// Tangents that follow a surface.
/// eq   t = normalise(sum of |n0| (x (b - a) + y (c - a)) over the triangles at a vertex)
///      x and y are the coordinates of the rest tangent along the rest edges, and n0 is the cross product of these
///      edges.
///      An affine map M of the surface gives normalise(M t0), as skinning does.
/// in   faces        with tangents;   positions[V]
///      rest_tangents[V]  w is kept; vertices without area keep the whole tangent
/// out  tangents[V]  xyz unit
/// err  size_mismatch, index_out_of_range     cost O(V + T), no allocation
struct SurfaceTangentsJob {
  const SurfaceFaces* faces = nullptr;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec4> rest_tangents;
  std::span<glm::vec4> tangents;
};
SINEW_API ErrorCode check(const SurfaceTangentsJob& job) noexcept;
SINEW_API void run_unchecked(const SurfaceTangentsJob& job) noexcept;

}  // namespace sinew
