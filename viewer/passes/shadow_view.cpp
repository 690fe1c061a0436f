// SPDX-License-Identifier: MIT
#include "viewer/passes/shadow_view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

constexpr double kMargin = 1.01;  // because the filter reads beyond the outermost vertex
constexpr double kSmallest_m = 1e-6;

struct Sphere {
  glm::dvec3 centre;
  double radius_m;
};

Sphere sphere_around(const Aabb& bounds) {
  const glm::dvec3 lower(bounds.lower), upper(bounds.upper);
  return {0.5 * (lower + upper), std::max(kMargin * 0.5 * glm::length(upper - lower), kSmallest_m)};
}

/// Axes of the map: x = right, y = up, z towards the light.
struct Axes {
  glm::dvec3 right, up;

  explicit Axes(const glm::dvec3& to_light) {
    const glm::dvec3 aside = std::abs(to_light.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    right = glm::normalize(glm::cross(aside, to_light));
    up = glm::cross(to_light, right);
  }
};

/// Matrix row for p -> scale * dot(axis, p - origin) + offset.
glm::dvec4 row(const glm::dvec3& axis, double scale, const glm::dvec3& origin, double offset) {
  return glm::dvec4(axis * scale, offset - scale * glm::dot(axis, origin));
}

}  // namespace

std::array<glm::dvec4, 4> ShadowView::map_from(const Affined& world_from_space) const noexcept {
  std::array<glm::dvec4, 4> product;
  for (std::size_t r = 0; r < 4; ++r) {
    const glm::dvec4& by = map_from_world[r];
    product[r] = by.x * world_from_space.row[0] + by.y * world_from_space.row[1] + by.z * world_from_space.row[2] +
                 glm::dvec4(0.0, 0.0, 0.0, by.w);
  }
  return product;
}

ShadowView shadow_view(const Aabb& bounds, const glm::dvec3& to_light) {
  const auto [centre, radius] = sphere_around(bounds);
  const Axes axes(to_light);
  ShadowView view;
  view.map_from_world = {row(axes.right, 1.0 / radius, centre, 0.0), row(axes.up, 1.0 / radius, centre, 0.0),
                         row(to_light, 0.5 / radius, centre, 0.5), glm::dvec4(0.0, 0.0, 0.0, 1.0)};
  view.texel_m = 2.0 * radius / kShadowSize;
  return view;
}

ShadowView spot_shadow_view(const Aabb& bounds, const glm::dvec3& position, const glm::dvec3& to_light,
                            double cone_rad) {
  const auto [centre, radius] = sphere_around(bounds);
  const double distance = glm::length(centre - position), far = distance + radius,
               near = std::max(distance - radius, 1e-3 * far);
  const double slope = kMargin * std::tan(std::min(cone_rad, kWidestCone_rad));
  const Axes axes(to_light);
  const double depth_scale = near / (far - near);
  ShadowView view;
  view.map_from_world = {row(axes.right, 1.0 / slope, position, 0.0), row(axes.up, 1.0 / slope, position, 0.0),
                         row(to_light, depth_scale, position, depth_scale * far), row(to_light, -1.0, position, 0.0)};
  view.texel_m = 2.0 * slope / kShadowSize;
  return view;
}

}  // namespace sinew::viewer
