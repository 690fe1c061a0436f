// SPDX-License-Identifier: MIT
#include "viewer/app/camera/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

constexpr double kZoomPerStep = 0.9, kZoomRange = 1000.0;
// Fraction of each side that the framed points fill: sqrt(0.8), which is 80 % of the area.
constexpr double kFilledSide = 0.894427190999916;
constexpr double kNearest = 0.02;    // least distance from the eye, relative to the depth of the framed points
constexpr double kRounding = 1e-12;  // rounding tolerance, relative to the coordinates of the points

struct Axes {
  glm::dvec3 right, up, back;  // world space; back points from the target to the eye
};

Axes axes_of(double yaw, double pitch) noexcept {
  const double sy = std::sin(yaw), cy = std::cos(yaw), sp = std::sin(pitch), cp = std::cos(pitch);
  return {{cy, 0.0, -sy}, {-sy * sp, cp, -cy * sp}, {sy * cp, sp, cy * cp}};
}

}  // namespace

glm::dvec3 OrbitCamera::eye() const noexcept {
  const Axes axes = axes_of(yaw_rad, pitch_rad);
  return target + distance_m * (axes.back - aside * axes.right - above * axes.up);
}

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

void OrbitCamera::frame(std::span<const glm::vec3> points, double aspect, const FreePart& free) noexcept {
  const Axes axes = axes_of(yaw_rad, pitch_rad);
  const double slope_y = std::tan(0.5 * fov_y_rad), slope_x = slope_y * std::max(aspect, 1e-3);
  const double middle_x = 0.5 * (free.right + free.left) * slope_x;
  const double middle_y = 0.5 * (1.0 + free.bottom) * slope_y;
  const double half_x = kFilledSide * 0.5 * (free.right - free.left) * slope_x;
  const double half_y = kFilledSide * 0.5 * (1.0 - free.bottom) * slope_y;
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  double right = kNever, left = kNever, top = kNever, bottom = kNever, nearest = kNever, farthest = -kNever;
  for (const glm::dvec3 p : points) {
    const double x = glm::dot(p, axes.right), y = glm::dot(p, axes.up), z = glm::dot(p, axes.back);
    right = std::max(right, x + (middle_x + half_x) * z);
    left = std::max(left, -x - (middle_x - half_x) * z);
    top = std::max(top, y + (middle_y + half_y) * z);
    bottom = std::max(bottom, -y - (middle_y - half_y) * z);
    nearest = std::max(nearest, z);
    farthest = std::min(farthest, z);
  }
  const double fitting = std::max((right + left) / (2.0 * half_x), (top + bottom) / (2.0 * half_y));
  const double eye_z = std::max(fitting, nearest + kNearest * (nearest - farthest));
  const double middle = 0.5 * (nearest + farthest);
  if (points.empty() || !(eye_z - middle > kRounding * (std::abs(eye_z) + std::abs(middle)))) {
    const glm::vec3 at = points.empty() ? glm::vec3(0.0f) : points.front();
    return frame(Aabb{at - 0.5f, at + 0.5f}, aspect, free);
  }
  distance_m = scale_m_ = eye_z - middle;
  aside = middle_x;
  above = middle_y;
  const double eye_x = 0.5 * (right - left) - middle_x * eye_z, eye_y = 0.5 * (top - bottom) - middle_y * eye_z;
  target = (eye_x + aside * distance_m) * axes.right + (eye_y + above * distance_m) * axes.up + middle * axes.back;
}

void OrbitCamera::frame(const Aabb& bounds, double aspect, const FreePart& free) noexcept {
  if (bounds.empty()) return frame(std::span<const glm::vec3>(), aspect, free);
  glm::vec3 corners[8];
  for (int c = 0; c < 8; ++c)
    corners[c] = {(c & 1 ? bounds.upper : bounds.lower).x, (c & 2 ? bounds.upper : bounds.lower).y,
                  (c & 4 ? bounds.upper : bounds.lower).z};
  frame(corners, aspect, free);
}

void OrbitCamera::place(const glm::dvec3& eye, const glm::dvec3& to) noexcept {
  const glm::dvec3 back = eye - to;
  const double length = glm::length(back);
  if (length == 0.0) return;
  target = to;
  aside = above = 0.0;
  distance_m = scale_m_ = length;
  pitch_rad = std::clamp(std::atan2(back.y, std::hypot(back.x, back.z)), -kSteepest_rad, kSteepest_rad);
  if (back.x != 0.0 || back.z != 0.0) yaw_rad = std::atan2(back.x, back.z);
}

void OrbitCamera::take_over(const View& view, const Aabb& bounds) noexcept {
  if (!view.parallel()) fov_y_rad = view.fov_y_rad;
  const glm::dvec3 from = eye_of(view), ahead = -glm::dvec3(view.view_from_world.row[2]);
  const glm::dvec3 middle = bounds.empty() ? from : 0.5 * (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper));
  double depth = glm::dot(middle - from, ahead);
  if (!(depth > view.near_m)) depth = std::max(2.0 * view.near_m, scale_m_);  // the view looks away from the scene
  const double distance = view.parallel() ? view.half_height_m / std::tan(0.5 * fov_y_rad) : depth;
  place(from + (depth - distance) * ahead, from + depth * ahead);
}

View OrbitCamera::view(const Aabb& bounds) const {
  const Axes axes = axes_of(yaw_rad, pitch_rad);
  const glm::dvec3 ahead = target - distance_m * (aside * axes.right + above * axes.up);
  return look_at(eye(), ahead, fov_y_rad, near_plane_for(eye(), bounds));
}

}  // namespace sinew::viewer
