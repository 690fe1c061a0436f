// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>

#include "runtime/model/mesh.h"

namespace sinew {

/// The corner positions of face f, in double so that products neither overflow nor underflow.
inline std::array<glm::dvec3, 3> face_positions(const Primitive& p, std::size_t f) noexcept {
  return {glm::dvec3(p.positions[p.indices[3 * f]]), glm::dvec3(p.positions[p.indices[3 * f + 1]]),
          glm::dvec3(p.positions[p.indices[3 * f + 2]])};
}

/// Normal of a face whose front is counter-clockwise; its length is twice the area.
inline glm::dvec3 face_area_normal(const std::array<glm::dvec3, 3>& p) noexcept {
  return glm::cross(p[1] - p[0], p[2] - p[0]);
}

/// v / |v|, or `fallback` if v is zero or not finite.
inline glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& fallback) noexcept {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0.0 && std::isfinite(length) ? v / length : fallback;
}

/// Angle between a and b in radians; 0 if one of them is zero. Uses atan2, so it is accurate near 0 and near pi.
inline double angle_between(const glm::dvec3& a, const glm::dvec3& b) noexcept {
  const glm::dvec3 normal = glm::cross(a, b);
  return std::atan2(std::sqrt(glm::dot(normal, normal)), glm::dot(a, b));
}

}  // namespace sinew
