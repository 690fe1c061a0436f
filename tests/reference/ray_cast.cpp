// SPDX-License-Identifier: MIT
#include "tests/reference/ray_cast.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sinew::reference {
namespace {

/// Permutes and shears the axes so that the ray runs along the third one.
struct Shear {
  int x, y, z;
  glm::dvec3 factor;

  explicit Shear(const glm::dvec3& d) {
    const glm::dvec3 size = glm::abs(d);
    z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    x = (z + 1) % 3;
    y = (z + 2) % 3;
    if (d[z] < 0.0) std::swap(x, y);  // keeps the winding
    factor = {d[x] / d[z], d[y] / d[z], 1.0 / d[z]};
  }
  glm::dvec3 operator()(const glm::dvec3& p) const {
    return {p[x] - factor.x * p[z], p[y] - factor.y * p[z], factor.z * p[z]};
  }
};

/// Twice the signed area of (0, a, b). Two triangles that share an edge get exactly opposite values for it.
double edge(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.y - a.y * b.x; }

/// True if the area exceeds the rounding error of the edges.
bool has_area(const RayTriangle& triangle) {
  const glm::dvec3 e1 = triangle.corners[1] - triangle.corners[0], e2 = triangle.corners[2] - triangle.corners[0];
  const glm::dvec3 n = glm::cross(e1, e2);
  return glm::dot(n, n) > 1e-28 * glm::dot(e1, e1) * glm::dot(e2, e2);
}

}  // namespace

std::optional<RayHit> cast(const std::vector<RayTriangle>& triangles, const glm::dvec3& from,
                           const glm::dvec3& direction, double limit) {
  const Shear shear(direction);
  std::optional<RayHit> nearest;
  for (const RayTriangle& triangle : triangles) {
    if (!has_area(triangle)) continue;
    const glm::dvec3 a = shear(triangle.corners[0] - from), b = shear(triangle.corners[1] - from),
                     c = shear(triangle.corners[2] - from);
    const double u = -edge(b, c), v = -edge(c, a), w = -edge(a, b), sum = u + v + w;
    if (u < 0.0 || v < 0.0 || w < 0.0 || !(sum > 0.0)) continue;
    const double t = (u * a.z + v * b.z + w * c.z) / sum;
    if (t <= 0.0 || t >= (nearest ? nearest->t : limit)) continue;
    const glm::dvec3 n = (u * triangle.normals[0] + v * triangle.normals[1] + w * triangle.normals[2]) / sum;
    nearest = RayHit{t, glm::normalize(n), triangle.material};
  }
  return nearest;
}

glm::dvec3 leave_surface(const glm::dvec3& point, const glm::dvec3& normal, double roundoff) {
  // Each coordinate is off by roundoff times itself, the normal by a few units in its last place. In all that is below
  // 2 * roundoff * (|x| + |y| + |z|). Twice that also covers the roundings of the intersection.
  const glm::dvec3 size = glm::abs(point);
  return point + normal * (4.0 * roundoff * (size.x + size.y + size.z));
}

double open_share(const std::vector<RayTriangle>& triangles, const glm::dvec3& from, const glm::dvec3& normal,
                  double radius, int ray_count) {
  const glm::dvec3 aside = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 tangent = glm::normalize(glm::cross(normal, aside)), bitangent = glm::cross(normal, tangent);
  int open = 0;
  for (int i = 0; i < ray_count; ++i) {
    std::uint32_t reversed = 0;
    for (int bit = 0; bit < 32; ++bit) reversed |= (static_cast<std::uint32_t>(i) >> bit & 1u) << (31 - bit);
    const double angle = 2.0 * std::numbers::pi * reversed * 0x1p-32,
                 height2 = (i + 0.5) / ray_count;  // cos^2 is distributed evenly
    const glm::dvec3 flat = tangent * std::cos(angle) + bitangent * std::sin(angle);
    const glm::dvec3 direction = flat * std::sqrt(1.0 - height2) + normal * std::sqrt(height2);
    if (!cast(triangles, from, direction, radius)) ++open;
  }
  return static_cast<double>(open) / ray_count;
}

}  // namespace sinew::reference
