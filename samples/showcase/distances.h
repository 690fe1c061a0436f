// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace sinew::showcase {

// Signed distances to solids: negative inside. No distance grows much faster than the true one. Solids are joined with
// rounded seams by Quilez' polynomial minimum.

/// Accurate near the surface; exact for a sphere.
inline float ellipsoid(const glm::vec3& p, const glm::vec3& centre, const glm::vec3& radii) {
  const glm::vec3 q = (p - centre) / radii;
  const float gradient = glm::length(q / radii);
  return gradient > 0.0f ? glm::length(q) * (glm::length(q) - 1.0f) / gradient : -std::min({radii.x, radii.y, radii.z});
}

/// A rod from `a` to `b` with radii `at_a` and `at_b`.
inline float rod(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, float at_a, float at_b) {
  const glm::vec3 along = b - a;
  const float t = glm::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0f, 1.0f);
  return glm::distance(p, a + t * along) - glm::mix(at_a, at_b, t);
}

/// A wall along half an ellipse of `radii` around the origin; it opens towards -Z and continues straight there.
/// `height` is its height, `radius` half its thickness; top and bottom are rounded.
inline float arch(const glm::vec3& p, const glm::vec2& radii, float height, float radius) {
  const glm::vec2 q = glm::vec2(p.x, std::max(p.z, 0.0f)) / radii;
  const float from_origin = glm::length(q), gradient = std::max(glm::length(q / radii), 1e-6f);
  const float across = from_origin * (from_origin - 1.0f) / gradient;
  const float above = std::max(std::abs(p.y) - 0.5f * height + radius, 0.0f);
  return glm::length(glm::vec2(across, above)) - radius;
}

/// Union of both solids; the seam is rounded over `blend`.
inline float joined(float a, float b, float blend) {
  const float h = std::max(blend - std::abs(a - b), 0.0f) / blend;
  return std::min(a, b) - 0.25f * h * h * blend;
}

/// The solid without the hole; the rim is rounded over `blend`.
inline float carved(float solid, float hole, float blend) { return -joined(-solid, hole, blend); }

}  // namespace sinew::showcase
