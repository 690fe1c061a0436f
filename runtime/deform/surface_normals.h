// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/deform/surface_faces.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// Elements of SurfaceNormalsJob::sums: the points in tiles of up to 16.
constexpr std::size_t surface_sums(const SurfaceFaces& faces) noexcept {
  return (std::size_t{faces.point_count} + 15) / 16 * 16;
}

/// Smooth normals of a surface from its positions alone.
/// eq   n = normalise(sum of (b - a) x (c - a) over the triangles at a point), negated when `turned`. Weighted by area
///      the sum is the vector area of the ring around the point: it does not depend on how the ring is cut into
///      triangles, and small triangles, which the step of a geometry cache disturbs most, count least
/// in   faces        of the mesh (join_surface);   positions[V];   turned  the triangles wind around the inside
///      rest_normals[V]  kept by points without area
///      sums[surface_sums(faces)]  scratch
/// out  normals[V]   unit. Edges and sums are float: off by at most 8 u sum |b - a| |c - a| / |sum of the cross
/// products|
///      radians, u = 2^-24, for edges of 1e-9 to 1e9 m
/// cost O(V + T), no allocation
struct SurfaceNormalsJob {
  const SurfaceFaces* faces = nullptr;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> rest_normals;
  bool turned = false;
  std::span<glm::vec4> sums;
  std::span<glm::vec3> normals;
};
ErrorCode check(const SurfaceNormalsJob& job) noexcept;
void run_unchecked(const SurfaceNormalsJob& job) noexcept;

/// Tangents that follow a surface.
/// eq   t = normalise(sum of |n0| (x (b - a) + y (c - a)) over the triangles at a vertex), where x and y give the
/// tangent
///      at rest along the edges at rest and n0 is their cross product: an affine map M of the surface gives
///      normalise(M t0), as skinning does
/// in   faces        with tangents;   positions[V]
///      rest_tangents[V]  w is kept, and all of it by vertices without area
/// out  tangents[V]  xyz unit
/// cost O(V + T), no allocation
struct SurfaceTangentsJob {
  const SurfaceFaces* faces = nullptr;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec4> rest_tangents;
  std::span<glm::vec4> tangents;
};
ErrorCode check(const SurfaceTangentsJob& job) noexcept;
void run_unchecked(const SurfaceTangentsJob& job) noexcept;

}  // namespace sinew
