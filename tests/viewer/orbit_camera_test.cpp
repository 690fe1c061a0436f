// SPDX-License-Identifier: MIT
#include "viewer/app/camera/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

// Position of a world point in the picture: x and y in [-1, 1] if it is visible, z = distance from the eye plane.
glm::dvec3 picture_of(const View& view, double aspect, const glm::dvec3& point) {
  const glm::dvec3 p = transform_point(view.view_from_world, point);
  const double slope = std::tan(0.5 * view.fov_y_rad);
  return {p.x / (-p.z * slope * aspect), p.y / (-p.z * slope), -p.z};
}

Aabb box(glm::vec3 lower, glm::vec3 upper) {
  Aabb b;
  b.add(lower);
  b.add(upper);
  return b;
}

TEST(orbit_camera, looks_from_the_front_slightly_from_the_right_and_above) {
  const OrbitCamera camera;
  EXPECT_GT(camera.eye().z, 0.0);
  EXPECT_GT(camera.eye().x, 0.0);
  EXPECT_GT(camera.eye().y, 0.0);
  EXPECT_NEAR(glm::length(camera.eye() - camera.target), camera.distance_m, 1e-12);
}

// The largest distance of a corner of the box from the middle of the picture, and the nearest corner.
std::pair<double, double> outermost_and_nearest(const View& view, double aspect, const Aabb& bounds) {
  double outermost = 0.0, nearest = 1e300;
  for (int c = 0; c < 8; ++c) {
    const glm::dvec3 corner((c & 1 ? bounds.upper : bounds.lower).x, (c & 2 ? bounds.upper : bounds.lower).y,
                            (c & 4 ? bounds.upper : bounds.lower).z);
    const glm::dvec3 seen = picture_of(view, aspect, corner);
    outermost = std::max({outermost, std::abs(seen.x), std::abs(seen.y)});
    nearest = std::min(nearest, seen.z);
  }
  return {outermost, nearest};
}

TEST(orbit_camera, framing_fills_80_percent_of_the_picture) {
  const double side = std::sqrt(0.8);  // of the side that limits the size
  const Aabb boxes[] = {box({-1, -1, -1}, {1, 1, 1}), box({100, 0, -3}, {130, 0.1f, 5}),
                        box({-1e-3f, 0, 0}, {1e-3f, 4e-3f, 1e-3f}), box({-70, 0, -155}, {70, 79, 5}),
                        box({0, -5, 0}, {0, 5, 0})};
  for (const auto& bounds : boxes)
    for (const double aspect : {0.4, 1.0, 16.0 / 9.0})
      for (const double yaw : {0.0, 0.46, 2.0, -2.9})
        for (const double fov : {0.2, 0.785, 1.9}) {
          OrbitCamera camera;
          camera.yaw_rad = yaw;
          camera.fov_y_rad = fov;
          camera.frame(bounds, aspect);
          const View view = camera.view(bounds);
          const auto [outermost, nearest] = outermost_and_nearest(view, aspect, bounds);
          if (fov < 1.0)
            EXPECT_NEAR(outermost, side, 1e-6);
          else
            EXPECT_LT(outermost, side + 1e-6) << "the nearest corner keeps away from the eye";
          EXPECT_GT(nearest, view.near_m);
        }
}

/// Of points in the picture.
struct Extent {
  double left = 2.0, right = -2.0, bottom = 2.0, top = -2.0;
};

Extent extent_of(const View& view, double aspect, std::span<const glm::vec3> points) {
  Extent extent;
  for (const glm::dvec3 p : points) {
    const glm::dvec3 seen = picture_of(view, aspect, p);
    extent = {std::min(extent.left, seen.x), std::max(extent.right, seen.x), std::min(extent.bottom, seen.y),
              std::max(extent.top, seen.y)};
  }
  return extent;
}

TEST(orbit_camera, zooms_from_where_it_is_placed_however_far_that_is) {
  for (const double distance : {1e-5, 1.0, 1e5}) {
    OrbitCamera camera;
    camera.place({0.0, 0.0, distance}, {0.0, 0.0, 0.0});
    camera.zoom(2.0);
    EXPECT_NEAR(camera.distance_m / distance, 0.81, 1e-9) << distance;
    camera.zoom(-1000.0);
    EXPECT_NEAR(camera.distance_m / distance, 1000.0, 1e-6) << distance;
  }
}

TEST(orbit_camera, framing_puts_points_in_the_middle) {
  const glm::vec3 points[] = {{0, 0, 0}, {4, 1, 0}, {1, 3, 2}, {0, 1, 5}};
  OrbitCamera camera;
  camera.yaw_rad = 0.8;
  camera.frame(points, 1.2);
  const Extent seen = extent_of(camera.view({}), 1.2, points);
  // The points are as far from both sides of one pair of edges, and none is nearer to any.
  const double side = std::sqrt(0.8);
  EXPECT_NEAR(std::max(std::min(seen.right, -seen.left), std::min(seen.top, -seen.bottom)), side, 1e-9);
  EXPECT_LT(std::max({seen.right, -seen.left, seen.top, -seen.bottom}), side + 1e-9);
}

TEST(orbit_camera, framing_fills_80_percent_of_what_a_panel_leaves_free) {
  const glm::vec3 wide[] = {{-3, 0, 0}, {3, 1, 0}, {0, 0.5f, 2}}, high[] = {{0, 0, 0}, {0.2f, 2, 0}, {0.1f, 1, 1}};
  for (const FreePart free : {FreePart{-0.4, 1.0}, FreePart{-1.0, 0.3}}) {
    OrbitCamera camera;
    camera.frame(wide, 1.6, free);
    const double half = 0.5 * std::sqrt(0.8) * (free.right - free.left), middle = 0.5 * (free.right + free.left);
    Extent seen = extent_of(camera.view({}), 1.6, wide);
    EXPECT_NEAR(seen.left, middle - half, 1e-9);
    EXPECT_NEAR(seen.right, middle + half, 1e-9);
    camera.frame(high, 1.6, free);
    seen = extent_of(camera.view({}), 1.6, high);
    EXPECT_NEAR(seen.top - seen.bottom, 2.0 * std::sqrt(0.8), 1e-9);
    EXPECT_LT(std::max(seen.right - middle, middle - seen.left), half);
    EXPECT_NEAR(picture_of(camera.view({}), 1.6, camera.target).x, middle, 1e-9);
    camera.orbit(200.0, 40.0, 600.0);
    camera.zoom(2.0);
    EXPECT_NEAR(picture_of(camera.view({}), 1.6, camera.target).x, middle, 1e-9) << "turns around what is framed";
    camera.frame(high, 1.6, {-1.0, 1.0, -0.4});
    seen = extent_of(camera.view({}), 1.6, high);
    EXPECT_NEAR(seen.top, 0.3 + 0.7 * std::sqrt(0.8), 1e-9) << "above a timeline";
    EXPECT_NEAR(seen.bottom, 0.3 - 0.7 * std::sqrt(0.8), 1e-9);
    camera.orbit(-90.0, 30.0, 600.0);
    EXPECT_NEAR(picture_of(camera.view({}), 1.6, camera.target).y, 0.3, 1e-9);
    camera.place({0, 0, 5}, {0, 0, 0});
    EXPECT_NEAR(picture_of(camera.view({}), 1.6, {0, 0, 0}).x, 0.0, 1e-9) << "placed cameras look at their target";
  }
}

TEST(orbit_camera, framing_keeps_the_direction_and_survives_boxes_without_extent) {
  OrbitCamera camera;
  camera.yaw_rad = 1.0;
  camera.pitch_rad = -0.4;
  camera.frame(Aabb{}, 1.5);
  EXPECT_LT(glm::length(camera.target), 1.0);
  EXPECT_EQ(camera.yaw_rad, 1.0);
  EXPECT_EQ(camera.pitch_rad, -0.4);
  EXPECT_GT(camera.distance_m, 1.0);
  camera.frame(box({30, 40, 0}, {30, 40, 0}), 1.5);
  EXPECT_LT(glm::distance(camera.target, glm::dvec3(30, 40, 0)), 1.0);
  EXPECT_GT(camera.distance_m, 0.1);
  EXPECT_LT(camera.distance_m, 10.0);
}

TEST(orbit_camera, a_drag_over_the_whole_height_turns_half_around) {
  OrbitCamera camera;
  camera.yaw_rad = 0.25;
  const double distance = camera.distance_m;
  camera.orbit(300.0, 0.0, 600.0);
  EXPECT_NEAR(camera.yaw_rad, 0.25 - 0.5 * std::numbers::pi, 1e-12);
  camera.orbit(-300.0, 0.0, 600.0);
  EXPECT_NEAR(camera.yaw_rad, 0.25, 1e-12);
  EXPECT_EQ(camera.distance_m, distance);
}

TEST(orbit_camera, dragging_down_looks_from_above_and_never_tips_over) {
  OrbitCamera camera;
  const double before = camera.eye().y;
  camera.orbit(0.0, 20.0, 600.0);
  EXPECT_GT(camera.eye().y, before);
  for (const double drag : {1e5, -1e6}) {
    camera.orbit(0.0, drag, 600.0);
    EXPECT_LT(std::abs(camera.pitch_rad), 0.5 * std::numbers::pi);
    EXPECT_GT(camera.view({}).view_from_world.row[1].y, 0.0);  // up stays up
  }
}

TEST(orbit_camera, a_point_stays_under_the_mouse_while_moving) {
  OrbitCamera camera;
  camera.frame(box({0, 0, 0}, {3, 2, 1}), 2.0);
  const glm::dvec3 point = camera.target;  // in the plane that moves with the mouse
  const double width = 800.0, height = 400.0, dx = 90.0, dy = -35.0;
  const glm::dvec3 before = picture_of(camera.view({}), width / height, point);
  camera.pan(dx, dy, height);
  const glm::dvec3 after = picture_of(camera.view({}), width / height, point);
  EXPECT_NEAR((after.x - before.x) * 0.5 * width, dx, 1e-9);
  EXPECT_NEAR((after.y - before.y) * 0.5 * height, -dy, 1e-9);
}

TEST(orbit_camera, zoom_steps_undo_each_other_and_have_ends) {
  OrbitCamera camera;
  camera.frame(box({-1, -1, -1}, {1, 1, 1}), 1.0);
  const double start = camera.distance_m;
  camera.zoom(3.0);
  EXPECT_LT(camera.distance_m, start);
  camera.zoom(-3.0);
  EXPECT_NEAR(camera.distance_m, start, 1e-12 * start);
  camera.zoom(1e6);
  EXPECT_NEAR(camera.distance_m, start / 1000.0, 1e-9);
  camera.zoom(-1e6);
  EXPECT_NEAR(camera.distance_m, start * 1000.0, 1e-6);
}

TEST(orbit_camera, placing_puts_the_eye_where_it_was_asked_for) {
  OrbitCamera camera;
  const glm::dvec3 eye(-3.0, 5.0, -8.0), to(1.0, 1.0, 2.0);
  camera.place(eye, to);
  EXPECT_LT(glm::length(camera.eye() - eye), 1e-12);
  EXPECT_EQ(camera.target, to);
  camera.place(to, to);  // no direction: no effect
  EXPECT_LT(glm::length(camera.eye() - eye), 1e-12);
  camera.place({0, 10, 0}, {0, 0, 0});  // straight down is limited to kSteepest_rad
  EXPECT_NEAR(camera.pitch_rad, OrbitCamera::kSteepest_rad, 1e-12);
}

TEST(orbit_camera, takes_over_from_a_view_without_moving_the_picture) {
  const Aabb scene = box({-1, -1, -1}, {1, 1, 1});
  const View given = look_at({-3.0, 2.0, 6.0}, {0.5, 0.0, 0.0}, 0.6, 0.01);
  OrbitCamera camera;
  camera.take_over(given, scene);
  const View taken = camera.view(scene);
  for (const glm::dvec3 p : {glm::dvec3(0.0), glm::dvec3(1.0, 0.5, -1.0)})
    EXPECT_LT(glm::length(picture_of(taken, 1.0, p) - picture_of(given, 1.0, p)), 1e-12);
  EXPECT_LT(glm::length(camera.target - glm::dvec3(0.5, 0.0, 0.0)), 1.0) << "it turns round the scene";
}

TEST(orbit_camera, takes_over_a_view_that_looks_away_at_the_distance_of_what_was_framed_last) {
  const Aabb scene = box({-1, -1, -1}, {1, 1, 1});
  OrbitCamera camera;
  camera.frame(scene, 1.0);
  const double framed_m = camera.distance_m;
  EXPECT_GT(framed_m, 1.0);
  const View away = look_at({0.0, 0.0, 5.0}, {0.0, 0.0, 9.0}, 0.6, 0.01);
  camera.take_over(away, scene);
  EXPECT_LT(glm::length(camera.eye() - glm::dvec3(0.0, 0.0, 5.0)), 1e-9);
  EXPECT_LT(glm::length(camera.target - glm::dvec3(0.0, 0.0, 5.0 + framed_m)), 1e-9);
}

TEST(orbit_camera, takes_over_the_size_that_a_parallel_view_shows) {
  const Aabb scene = box({-1, -1, -1}, {1, 1, 1});
  View given = look_at({0.0, 0.0, 50.0}, {0.0, 0.0, 0.0}, 0.8, 0.01);
  given.half_height_m = 2.0;
  given.far_m = 100.0;
  OrbitCamera camera;
  camera.take_over(given, scene);
  EXPECT_LT(glm::length(camera.target), 1e-9);
  EXPECT_NEAR(picture_of(camera.view(scene), 1.0, {0.0, 2.0, 0.0}).y, 1.0, 1e-9);
}

}  // namespace
}  // namespace sinew::viewer
