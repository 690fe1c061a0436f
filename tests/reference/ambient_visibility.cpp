// SPDX-License-Identifier: MIT
#include "tests/reference/ambient_visibility.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "importer/ambient/visibility_rays.h"
#include "tests/reference/ray_cast.h"

namespace sinew::reference {
namespace {

struct Face {
  glm::dvec3 start, normal;
  double angle;
  std::uint64_t corner;
};

RayTriangle triangle_of(const VisibilitySurface& surface, std::size_t first, bool reversed) {
  RayTriangle t;
  for (std::size_t c = 0; c < 3; ++c)
    t.corners[c] = glm::dvec3(surface.positions[surface.indices[first + (reversed ? 2 - c : c)]]);
  for (glm::dvec3& n : t.normals) n = {0, 0, 1};
  return t;
}

std::vector<RayTriangle> blockers_of(std::span<const VisibilitySurface> surfaces) {
  std::vector<RayTriangle> all;
  for (const VisibilitySurface& surface : surfaces)
    for (std::size_t i = 0; surface.blocks && i < surface.indices.size(); i += 3) {
      all.push_back(triangle_of(surface, i, false));
      if (surface.both_sides) all.push_back(triangle_of(surface, i, true));
    }
  return all;
}

bool are_one(const VisibilitySurface& a, std::size_t i, const VisibilitySurface& b, std::size_t j) {
  if (a.normals.empty() || b.normals.empty()) return &a == &b && i == j;
  return a.positions[i] == b.positions[j] && a.normals[i] == b.normals[j];
}

/// The faces at a vertex and at all vertices that count as the same point (are_one()).
std::vector<Face> faces_of(std::span<const VisibilitySurface> surfaces, const VisibilitySurface& of,
                           std::size_t vertex) {
  std::vector<Face> faces;
  std::uint64_t corner = 0;
  for (const VisibilitySurface& surface : surfaces)
    for (std::size_t i = 0; i < surface.indices.size(); ++i, ++corner) {
      if (!are_one(of, vertex, surface, surface.indices[i])) continue;
      const RayTriangle t = triangle_of(surface, i / 3 * 3, false);
      const glm::dvec3 p = t.corners[i % 3], a = t.corners[(i + 1) % 3] - p, b = t.corners[(i + 2) % 3] - p;
      const glm::dvec3 n = glm::cross(a, b);
      if (n == glm::dvec3(0.0)) continue;
      const glm::dvec3 unit = glm::normalize(n), centroid = (t.corners[0] + t.corners[1] + t.corners[2]) / 3.0;
      faces.push_back({visibility_start(p, centroid, unit), unit, std::atan2(glm::length(n), glm::dot(a, b)), corner});
    }
  return faces;
}

double open_share_of(const std::vector<RayTriangle>& blockers, const Face& face, std::uint32_t rays,
                     const VisibilityOptions& options) {
  const VisibilityRays all(face.normal, rays, visibility_shift(options.seed, face.corner));
  std::uint32_t open = 0;
  for (std::uint32_t i = 0; i < rays; ++i) open += !cast(blockers, face.start, all.direction(i), options.distance_m);
  return static_cast<double>(open) / rays;
}

}  // namespace

std::vector<std::vector<double>> ambient_visibility(std::span<const VisibilitySurface> surfaces,
                                                    const VisibilityOptions& options) {
  const std::vector<RayTriangle> blockers = blockers_of(surfaces);
  std::vector<std::vector<double>> visibility;
  for (const VisibilitySurface& surface : surfaces) {
    std::vector<double>& out = visibility.emplace_back();
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const std::vector<Face> faces = faces_of(surfaces, surface, v);
      const double share = faces.empty() ? 1.0 : static_cast<double>(options.rays) / static_cast<double>(faces.size());
      const auto rays = static_cast<std::uint32_t>(std::max(std::ceil(share), 1.0));
      double open = 0.0, angles = 0.0;
      for (const Face& face : faces) {
        open += face.angle * open_share_of(blockers, face, rays, options);
        angles += face.angle;
      }
      out.push_back(angles > 0.0 ? open / angles : 1.0);
    }
  }
  return visibility;
}

}  // namespace sinew::reference
