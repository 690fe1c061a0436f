// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/deform/flat_faces.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// Normals of a deformed flat-shaded mesh. Its file has no normals, so glTF prescribes the normal of each triangle.
/// eq   n = normalise((b - a) x (c - a)) for the three vertices of each triangle, negated when `turned`: a mirroring
///      skin reverses the winding, and the normals must still point outside
/// in   faces       of the mesh (sort_flat_faces); where triangles share a vertex, the last triangle decides
///      positions[V];   rest_normals[V]  kept by vertices of no triangle, and of triangles without area
/// out  normals[V]  unit, within 2e-6 of the exact normal of the positions. Computed in float if sin(b - a, c - a) >
///      1/8, the squared edge lengths are above 1e-30 and the squared area is below 1e30; in double otherwise.
/// err  size_mismatch, index_out_of_range
/// cost O(V), no allocation; about ten times as long where triangles share vertices
struct FlatNormalsJob {
  const FlatFaces* faces = nullptr;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> rest_normals;
  bool turned = false;
  std::span<glm::vec3> normals;
};

SINEW_API ErrorCode check(const FlatNormalsJob& job) noexcept;
SINEW_API void run_unchecked(const FlatNormalsJob& job) noexcept;

}  // namespace sinew
