// SPDX-License-Identifier: MIT
#include "viewer/app/camera/file_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

constexpr double kNarrowest_rad = 1e-3, kWidest_rad = std::numbers::pi - 1e-3;
constexpr double kSmallest_m = 1e-6;     // least value of lengths that must be positive
constexpr double kSmallestRange = 1e-6;  // least value of (far - near) / max(near, 1 m)

/// Unit vector along a column of the matrix; `fallback` if the joint scales the column to zero.
glm::dvec3 axis(const glm::dvec3& column, const glm::dvec3& fallback) {
  const double length = glm::length(column);
  return length > 0.0 ? column / length : fallback;
}

/// Half height of a picture of this aspect that contains both `half_height` and `half_width`.
double half_height_for(double half_height, double half_width, double aspect) {
  return std::max(half_height, half_width / aspect);
}

double fov_for(const Camera& camera, double aspect) {
  const double half = 0.5 * std::clamp(static_cast<double>(camera.fov_y_rad), kNarrowest_rad, kWidest_rad);
  const double height = std::tan(half), width = height * std::max(static_cast<double>(camera.aspect), 0.0);
  return std::min(2.0 * std::atan(half_height_for(height, width, aspect)),
                  kWidest_rad);  // a camera without an aspect has width 0, so its height decides
}

double far_behind(const Aabb& bounds, const glm::dvec3& eye) {
  const double reach = bounds.empty() ? 1.0 : glm::length(glm::dvec3(bounds.upper - bounds.lower));
  const glm::dvec3 middle = bounds.empty() ? eye : 0.5 * glm::dvec3(bounds.lower + bounds.upper);
  return glm::length(middle - eye) + reach;
}

}  // namespace

View view_of_camera(const Camera& camera, const Affine& world_from_camera, double aspect, const Aabb& bounds) {
  const Affined world = affine_cast<double>(world_from_camera);
  const glm::dvec3 eye = translation_of(world);
  const glm::dvec3 back = axis(linear_part(world)[2], {0.0, 0.0, 1.0}),
                   up = axis(linear_part(world)[1], {0.0, 1.0, 0.0});
  const double near = std::max(static_cast<double>(camera.near_m), camera.perspective ? kSmallest_m : 0.0);
  View view = look_at(eye, eye - back, fov_for(camera, aspect), near, up);
  if (!camera.perspective) {
    const double height = std::abs(static_cast<double>(camera.half_height)),
                 width = std::abs(static_cast<double>(camera.half_width));
    view.half_height_m = std::max(half_height_for(height, width, aspect), kSmallest_m);
  }
  view.far_m = camera.far_m > 0.0f ? static_cast<double>(camera.far_m)
               : view.parallel()   ? far_behind(bounds, eye)
                                   : 0.0;
  if (view.far_m > 0.0) view.far_m = std::max(view.far_m, near + kSmallestRange * std::max(near, 1.0));
  return view;
}

}  // namespace sinew::viewer
