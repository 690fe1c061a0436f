// SPDX-License-Identifier: MIT
#include "viewer/app/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

constexpr double kZoomPerStep = 0.9, kMargin = 1.08, kZoomRange = 1000.0;

struct Axes {
  glm::dvec3 right, up, back;   // of the camera, in world space; back points from the target to the eye
};

Axes axes_of(double yaw, double pitch) noexcept {
  const double sy = std::sin(yaw), cy = std::cos(yaw), sp = std::sin(pitch), cp = std::cos(pitch);
  return {{cy, 0.0, -sy}, {-sy * sp, cp, -cy * sp}, {sy * cp, sp, cy * cp}};
}

}  // namespace

glm::dvec3 OrbitCamera::eye() const noexcept { return target + distance_m * axes_of(yaw_rad, pitch_rad).back; }

void OrbitCamera::orbit(double dx, double dy, double height) noexcept {
  const double angle_per_pixel = std::numbers::pi / std::max(height, 1.0);
  yaw_rad = std::remainder(yaw_rad - dx * angle_per_pixel, 2.0 * std::numbers::pi);
  pitch_rad = std::clamp(pitch_rad + dy * angle_per_pixel, -kSteepest_rad, kSteepest_rad);
}

void OrbitCamera::pan(double dx, double dy, double height) noexcept {
  const double metres_per_pixel = 2.0 * distance_m * std::tan(0.5 * fov_y_rad) / std::max(height, 1.0);
  const Axes axes = axes_of(yaw_rad, pitch_rad);
  target += metres_per_pixel * (dy * axes.up - dx * axes.right);
}

void OrbitCamera::zoom(double steps) noexcept {
  distance_m = std::clamp(distance_m * std::pow(kZoomPerStep, steps), scale_m_ / kZoomRange, scale_m_ * kZoomRange);
}

void OrbitCamera::frame(const Aabb& bounds, double aspect) noexcept {
  glm::dvec3 lower(-0.5), upper(0.5);
  if (!bounds.empty()) lower = bounds.lower, upper = bounds.upper;
  const glm::dvec3 centre = 0.5 * (lower + upper);
  glm::dvec3 half = 0.5 * (upper - lower);
  if (glm::length(half) == 0.0) half = glm::dvec3(glm::length(centre) > 0.0 ? 0.01 * glm::length(centre) : 0.5);
  const Axes axes = axes_of(yaw_rad, pitch_rad);
  const double slope_y = std::tan(0.5 * fov_y_rad), slope_x = slope_y * std::max(aspect, 1e-3);
  double distance = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 c(corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y, corner & 4 ? half.z : -half.z);
    const double x = std::abs(glm::dot(c, axes.right)), y = std::abs(glm::dot(c, axes.up)), z = glm::dot(c, axes.back);
    distance = std::max(distance, std::max(x / slope_x, y / slope_y) + z);
  }
  target = centre;
  distance_m = scale_m_ = kMargin * distance;
}

void OrbitCamera::place(const glm::dvec3& eye, const glm::dvec3& to) noexcept {
  const glm::dvec3 back = eye - to;
  const double length = glm::length(back);
  if (length == 0.0) return;
  target = to;
  distance_m = scale_m_ = length;
  pitch_rad = std::clamp(std::atan2(back.y, std::hypot(back.x, back.z)), -kSteepest_rad, kSteepest_rad);
  if (back.x != 0.0 || back.z != 0.0) yaw_rad = std::atan2(back.x, back.z);
}

View OrbitCamera::view(const Aabb& bounds) const {
  return look_at(eye(), target, fov_y_rad, near_plane_for(eye(), bounds));
}

}  // namespace sinew::viewer
