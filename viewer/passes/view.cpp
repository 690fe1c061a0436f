// SPDX-License-Identifier: MIT
#include "viewer/passes/view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "viewer/passes/projection.h"

namespace sinew::viewer {

namespace {

struct Ball {
  glm::dvec3 centre;
  double radius;
};

Ball ball_around(const Aabb& bounds) {
  if (bounds.empty()) return {{0.0, 0.0, 0.0}, 1.0};
  const glm::dvec3 lower(bounds.lower), upper(bounds.upper);
  const double radius = 0.5 * glm::length(upper - lower);
  return {0.5 * (lower + upper), radius > 0.0 ? radius : 1.0};
}

}  // namespace

View look_at(const glm::dvec3& eye, const glm::dvec3& target, double fov_y_rad, double near_m, const glm::dvec3& up) {
  const glm::dvec3 sight = target - eye;
  const double distance = glm::length(sight);
  const glm::dvec3 back = distance > 0.0 ? -sight / distance : glm::dvec3(0.0, 0.0, 1.0);
  glm::dvec3 right = glm::cross(up, back);
  if (!(glm::length(right) > 1e-6 * glm::length(up)))  // `up` is zero or parallel to the line of sight
    right = glm::cross(std::abs(back.z) < 0.9 ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(1.0, 0.0, 0.0), back);
  right = glm::normalize(right);
  const glm::dvec3 above = glm::cross(back, right);
  View view;
  view.view_from_world = {
      {{right, -glm::dot(right, eye)}, {above, -glm::dot(above, eye)}, {back, -glm::dot(back, eye)}}};
  view.fov_y_rad = fov_y_rad;
  view.near_m = near_m;
  return view;
}

glm::dvec3 eye_of(const View& view) {
  const auto& m = view.view_from_world;
  return -(translation_of(m) * linear_part(m));  // R^T * t: the linear part is a rotation
}

Mat4<double> clip_from_view(const View& view, double aspect) {
  if (view.parallel()) {
    const double half_height = view.half_height_m, half_width = half_height * aspect;
    return orthographic(ViewBoxT<double>{-half_width, half_width, -half_height, half_height, -view.near_m, -view.far_m},
                        DepthMapping::reversed);
  }
  const Mat4<double> frame = perspective_frame(view.fov_y_rad, aspect, -1.0);
  return view.far_m > 0.0 ? with_depth(frame, DepthMapping::reversed, view.near_m, view.far_m)
                          : with_infinite_depth(frame, DepthMapping::reversed, view.near_m);
}

double near_plane_for(const glm::dvec3& eye, const Aabb& bounds) {
  const Ball ball = ball_around(bounds);
  const double distance = glm::length(eye - ball.centre);
  return std::max(0.5 * (distance - ball.radius), 0.002 * ball.radius);
}

bool is_out_of_view(const View& view, double aspect, const Affined& view_from_box, const Aabb& box) noexcept {
  if (box.empty()) return false;
  constexpr double kMargin = 1.0001;
  const double slope_y = view.parallel() ? 0.0 : kMargin * std::tan(0.5 * view.fov_y_rad),
               half_y = kMargin * view.half_height_m;
  std::array<bool, 6> outside{true, true, true, true, true, true};  // for each plane: all corners so far are outside it
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p = transform_point(
        view_from_box, glm::dvec3(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                                  corner & 4 ? box.upper.z : box.lower.z));
    const double reach_y = half_y - p.z * slope_y, reach_x = reach_y * aspect;
    outside[0] &= p.x > reach_x;
    outside[1] &= -p.x > reach_x;
    outside[2] &= p.y > reach_y;
    outside[3] &= -p.y > reach_y;
    outside[4] &= -p.z * kMargin < view.near_m;
    outside[5] &= view.far_m > 0.0 && -p.z > view.far_m * kMargin;
  }
  return std::any_of(outside.begin(), outside.end(), [](bool beyond) { return beyond; });
}

View view_of_all(const Aabb& bounds, double fov_y_rad, double aspect) {
  constexpr double margin = 1.06;
  const Ball ball = ball_around(bounds);
  const glm::dvec3 half = bounds.empty() ? glm::dvec3(0.5) : 0.5 * glm::dvec3(bounds.upper - bounds.lower);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.5, 0.35, 1.0));
  const View turned = look_at(ball.centre + direction, ball.centre, fov_y_rad, 1.0);
  const double tangent_y = std::tan(0.5 * fov_y_rad), tangent_x = tangent_y * aspect;
  double distance = 1e-3 * ball.radius;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 sign(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
    const glm::dvec3 p = transform_vector(turned.view_from_world, margin * sign * half);  // +z points to the viewer
    distance = std::max(distance, p.z + std::max(std::abs(p.x) / tangent_x, std::abs(p.y) / tangent_y));
  }
  const glm::dvec3 eye = ball.centre + distance * direction;
  return look_at(eye, ball.centre, fov_y_rad, near_plane_for(eye, bounds));
}

}  // namespace sinew::viewer
