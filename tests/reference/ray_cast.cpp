// SPDX-License-Identifier: MIT
#include "tests/reference/ray_cast.h"

#include <glm/geometric.hpp>

namespace sinew::reference {

std::optional<RayHit> cast(const std::vector<RayTriangle>& triangles, const glm::dvec3& from,
                           const glm::dvec3& direction, double limit) {
  std::optional<RayHit> nearest;
  for (const RayTriangle& triangle : triangles) {
    // Moeller and Trumbore 1997
    const glm::dvec3 e1 = triangle.corners[1] - triangle.corners[0], e2 = triangle.corners[2] - triangle.corners[0];
    const glm::dvec3 p = glm::cross(direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant <= 0.0) continue;
    const glm::dvec3 s = from - triangle.corners[0], q = glm::cross(s, e1);
    const double u = glm::dot(s, p) / determinant, v = glm::dot(direction, q) / determinant,
                 t = glm::dot(e2, q) / determinant;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || t <= 0.0 || t >= (nearest ? nearest->t : limit)) continue;
    const glm::dvec3 n = (1.0 - u - v) * triangle.normals[0] + u * triangle.normals[1] + v * triangle.normals[2];
    nearest = RayHit{t, glm::normalize(n), triangle.material};
  }
  return nearest;
}

}  // namespace sinew::reference
