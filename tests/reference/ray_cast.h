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
/// Watertight: a ray through a shared edge or corner meets at least one of the triangles around it. No ray meets a
/// triangle without area.   (Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection")
std::optional<RayHit> cast(const std::vector<RayTriangle>& triangles, const glm::dvec3& from,
                           const glm::dvec3& direction, double limit = 1e300);

/// Start of rays that leave a surface: the point, moved along the normal by more than its rounding error. So it lies in
/// front of the triangle it came from.
/// in   normal    geometric, unit;   roundoff  relative error of the point's coordinates (2^-24 when they were floats)
glm::dvec3 leave_surface(const glm::dvec3& point, const glm::dvec3& normal, double roundoff);

/// Share of the cosine-weighted hemisphere over `normal` from which light reaches `from`. Only blockers nearer than
/// `radius` count. The directions are the first `ray_count` Hammersley points, the same for every point.
double open_share(const std::vector<RayTriangle>& triangles, const glm::dvec3& from, const glm::dvec3& normal,
                  double radius, int ray_count);

}  // namespace sinew::reference
