// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace sinew::reference {

struct RayTriangle {
  glm::dvec3 corners[3];
  glm::dvec3 normals[3];
  std::size_t material = 0;
};

struct RayHit {
  double t = 0.0;
  glm::dvec3 normal{0.0};  ///< interpolated, unit
  std::size_t material = 0;
};

/// The nearest triangle whose front (counter-clockwise) side the ray meets with 0 < t < limit; all triangles are tried.
std::optional<RayHit> cast(const std::vector<RayTriangle>& triangles, const glm::dvec3& from,
                           const glm::dvec3& direction, double limit = 1e300);

}  // namespace sinew::reference
