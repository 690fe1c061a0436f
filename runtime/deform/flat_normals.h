// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/deform/flat_faces.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// Normals of a deformed mesh with flat faces: the file has no normals, so they are those of the triangles (G46).
/// eq   n = normalise((b - a) x (c - a)) for the three vertices of each triangle, negated when `turned`: a mirroring
///      skin reverses the winding, but the outside stays outside (G48)
/// in   faces       of the mesh (sort_flat_faces); where they share vertices, the last triangle decides
///      positions[V];   rest_normals[V]  kept by the vertices of triangles without area and of no triangle
/// out  normals[V]  unit, within 2e-6 of the exact normal of the positions: edges and cross product are float where
///      sin(b - a, c - a) exceeds 1/8 and the squares of lengths stay above 1e-30, that of the area below 1e30, and
///      double elsewhere
/// cost O(V), no allocation; where faces share vertices ten times as long
struct FlatNormalsJob {
  const FlatFaces* faces = nullptr;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> rest_normals;
  bool turned = false;
  std::span<glm::vec3> normals;
};

ErrorCode check(const FlatNormalsJob& job) noexcept;
void run_unchecked(const FlatNormalsJob& job) noexcept;

}  // namespace sinew
