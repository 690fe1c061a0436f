// SPDX-License-Identifier: MIT
#include "viewer/passes/shadow_view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

constexpr double kMargin = 1.01;  // the filter reads beyond the outermost vertex
constexpr double kSmallest_m = 1e-6;

glm::dvec4 row(const glm::dvec3& axis, double scale, const glm::dvec3& centre, double offset) {
  return glm::dvec4(axis * scale, offset - scale * glm::dot(axis, centre));
}

}  // namespace

ShadowView shadow_view(const Aabb& bounds, const glm::dvec3& to_light) {
  const glm::dvec3 lower(bounds.lower), upper(bounds.upper), centre = 0.5 * (lower + upper);
  const double radius = std::max(kMargin * 0.5 * glm::length(upper - lower), kSmallest_m);
  const glm::dvec3 aside = std::abs(to_light.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 right = glm::normalize(glm::cross(aside, to_light)), up = glm::cross(to_light, right);
  ShadowView view;
  view.map_from_world.row[0] = row(right, 1.0 / radius, centre, 0.0);
  view.map_from_world.row[1] = row(up, 1.0 / radius, centre, 0.0);
  view.map_from_world.row[2] = row(to_light, 0.5 / radius, centre, 0.5);
  view.texel_m = 2.0 * radius / kShadowSize;
  return view;
}

}  // namespace sinew::viewer
