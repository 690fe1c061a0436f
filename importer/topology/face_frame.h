// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>

#include "runtime/model/mesh.h"

namespace sinew {

/// The corners of face f in double: products of float coordinates neither overflow nor vanish.
inline std::array<glm::dvec3, 3> face_positions(const Primitive& p, std::size_t f) noexcept {
  return {glm::dvec3(p.positions[p.indices[3 * f]]), glm::dvec3(p.positions[p.indices[3 * f + 1]]),
          glm::dvec3(p.positions[p.indices[3 * f + 2]])};
}

/// Normal with twice the face's area as length, counter-clockwise front.
inline glm::dvec3 face_area_normal(const std::array<glm::dvec3, 3>& p) noexcept {
  return glm::cross(p[1] - p[0], p[2] - p[0]);
}

/// v / |v|, or `fallback` where v has no direction.
inline glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& fallback) noexcept {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0.0 && std::isfinite(length) ? v / length : fallback;
}

/// Angle between a and b, 0 where one is zero. From both sine and cosine, so that it is exact near 0 and pi (N03).
inline double angle_between(const glm::dvec3& a, const glm::dvec3& b) noexcept {
  const glm::dvec3 normal = glm::cross(a, b);
  return std::atan2(std::sqrt(glm::dot(normal, normal)), glm::dot(a, b));
}

/// Interior angle of the face at corner k, radians.
inline double corner_angle(const std::array<glm::dvec3, 3>& p, std::size_t k) noexcept {
  return angle_between(p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]);
}

}  // namespace sinew
