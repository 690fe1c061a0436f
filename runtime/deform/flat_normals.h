// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/math/conventions.h"

namespace sinew {

/// Normals of a deformed mesh with flat faces: the file has no normals, so they are those of the triangles (G46).
/// eq   n = normalise((b - a) x (c - a)) for the three vertices of each triangle, negated when `turned`: a mirroring
///      skin reverses the winding, but the outside stays outside (G48)
/// in   triangles[3T]  flat faces share no vertices; where they do, the last triangle decides
///      positions[V];   rest_normals[V]  kept by the vertices of triangles without area and of no triangle
/// out  normals[V]     unit
/// cost O(V + T), no allocation
void flat_normals(std::span<const std::uint32_t> triangles, std::span<const glm::vec3> positions,
                  std::span<const glm::vec3> rest_normals, bool turned, std::span<glm::vec3> normals) noexcept;

}  // namespace sinew
