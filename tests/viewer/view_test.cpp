// SPDX-License-Identifier: MIT
#include "viewer/passes/view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "runtime/math/inverse.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew::viewer {
namespace {

TEST(view, looks_along_minus_z_with_y_up) {
  const View view = look_at({3.0, 4.0, 5.0}, {0.0, 1.0, 0.0}, 0.8, 0.1);
  const glm::dvec3 target = transform_point(view.view_from_world, glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_NEAR(target.x, 0.0, 1e-12);
  EXPECT_NEAR(target.y, 0.0, 1e-12);
  EXPECT_NEAR(target.z, -std::sqrt(9.0 + 9.0 + 25.0), 1e-12);
  EXPECT_GT(transform_vector(view.view_from_world, glm::dvec3(0.0, 1.0, 0.0)).y, 0.0);
  EXPECT_NEAR(determinant(view.view_from_world), 1.0, 1e-12);
  const glm::dvec3 eye = eye_of(view);
  EXPECT_NEAR(glm::length(eye - glm::dvec3(3.0, 4.0, 5.0)), 0.0, 1e-12);
}

TEST(view, puts_the_eye_at_the_origin_and_the_target_ahead) {
  using V = glm::dvec3;
  test::FixedRandom random(1);
  for (int i = 0; i < 100; ++i) {
    const V eye = random.vec3<double>(-5, 5), target = random.vec3<double>(-5, 5), up = random.direction<double>();
    const Affined view = look_at(eye, target, 0.8, 0.1, up).view_from_world;
    EXPECT_TRUE(test::is_near(transform_point(view, eye), V(0), 1e-13));
    EXPECT_TRUE(test::is_near(transform_point(view, target), V(0, 0, -test::distance(eye, target)), 1e-13));
    const V up_seen = transform_vector(view, up);
    EXPECT_NEAR(up_seen.x, 0, 1e-12);
    EXPECT_GE(up_seen.y, 0);
    EXPECT_TRUE(test::is_near(view * inverse_rigid(view), Affined{}, 1e-13));
  }
}

TEST(view, up_along_the_line_of_sight_or_no_direction_at_all_still_gives_a_rotation) {
  const glm::dvec3 eye(1, 2, 3);
  for (const glm::dvec3& target : {glm::dvec3(0, 0, 0), glm::dvec3(0, 5, 0), eye}) {
    const Affined view = look_at(eye, target, 0.8, 0.1, eye - target).view_from_world;
    EXPECT_TRUE(test::is_near(view * inverse_rigid(view), Affined{}, 1e-14));
    EXPECT_NEAR(determinant(view), 1, 1e-14);
  }
}

TEST(view, clip_space_is_the_one_of_its_frustum_with_reversed_depth) {
  View view = look_at({0, 0, 0}, {0, 0, -1}, 2.0 * std::atan(0.5), 0.25);
  const auto projected = [&](double x, double y, double distance) {
    const Vec4<double> clip = clip_from_view(view, 2.0) * Vec4<double>(x, y, -distance, 1.0);
    return Vec3<double>(clip) / clip.w;
  };
  EXPECT_TRUE(test::is_near(projected(4.0, 2.0, 4.0), {1.0, 1.0, 0.25 / 4.0}, 1e-14));
  EXPECT_TRUE(test::is_near(projected(0.0, -0.125, 0.25), {0.0, -1.0, 1.0}, 1e-14));
  view.far_m = 100.0;
  EXPECT_TRUE(test::is_near(projected(0.0, 0.0, 0.25), {0.0, 0.0, 1.0}, 1e-14));
  EXPECT_TRUE(test::is_near(projected(100.0, 50.0, 100.0), {1.0, 1.0, 0.0}, 1e-14));
  view.half_height_m = 3.0;
  EXPECT_TRUE(test::is_near(projected(-6.0, 3.0, 0.25), {-1.0, 1.0, 1.0}, 1e-14));
  EXPECT_TRUE(test::is_near(projected(6.0, -3.0, 100.0), {1.0, -1.0, 0.0}, 1e-14));
}

TEST(view, stays_a_rotation_when_looking_straight_down_or_from_the_target_itself) {
  for (const glm::dvec3& eye : {glm::dvec3(0.0, 5.0, 0.0), glm::dvec3(0.0, -5.0, 0.0), glm::dvec3(0.0)}) {
    const View view = look_at(eye, {0.0, 0.0, 0.0}, 0.8, 0.1);
    EXPECT_NEAR(determinant(view.view_from_world), 1.0, 1e-12);
  }
  const View along_z = look_at({0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, 0.8, 0.1, {0.0, 0.0, 1.0});
  EXPECT_NEAR(determinant(along_z.view_from_world), 1.0, 1e-12);
}

TEST(view, of_all_holds_every_corner_in_wide_and_narrow_pictures) {
  Aabb box;
  box.add({-3.0f, 1.0f, 2.0f});
  box.add({40.0f, 3.0f, 7.0f});
  for (const double aspect : {0.4, 1.0, 2.5}) {
    const View view = view_of_all(box, 0.7, aspect);
    const double tangent = std::tan(0.35);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                         corner & 4 ? box.upper.z : box.lower.z);
      const glm::dvec3 v = transform_point(view.view_from_world, p);
      EXPECT_GT(-v.z, view.near_m);
      EXPECT_LE(std::abs(v.x), -v.z * tangent * aspect);
      EXPECT_LE(std::abs(v.y), -v.z * tangent);
    }
  }
}

/// Extent of a box in a perspective picture, relative to half of its width or height.
double share_of_picture(const Aabb& box, const View& view, double aspect) {
  const Mat4<double> clip = clip_from_view(view, aspect);
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                       corner & 4 ? box.upper.z : box.lower.z);
    const glm::dvec4 c = clip * glm::dvec4(transform_point(view.view_from_world, p), 1.0);
    largest = std::max({largest, std::abs(c.x / c.w), std::abs(c.y / c.w)});
  }
  return largest;
}

TEST(view, of_all_fills_the_picture_but_for_a_margin_from_the_right_of_the_front_and_above) {
  const glm::dvec3 middle(4.0, 2.0, -1.0), from = glm::normalize(glm::dvec3(0.5, 0.35, 1.0));
  for (const glm::dvec3& half : {glm::dvec3(3, 0.2, 0.5), {0.2, 3, 0.5}, {0.5, 0.2, 3}})
    for (const double aspect : {0.5, 1.0, 2.0}) {
      const Aabb box{glm::vec3(middle - half), glm::vec3(middle + half)};
      const Aabb larger{glm::vec3(middle - 1.06 * half), glm::vec3(middle + 1.06 * half)};
      const View view = view_of_all(box, 0.8, aspect);
      EXPECT_TRUE(test::is_near(glm::normalize(eye_of(view) - middle), from, 1e-6));
      EXPECT_NEAR(share_of_picture(larger, view, aspect), 1.0, 1e-6);
    }
  const glm::dvec3 eye = eye_of(view_of_all(Aabb{glm::vec3(-0.5f), glm::vec3(0.5f)}, 0.8, 1.0));
  EXPECT_TRUE(test::is_near(eye_of(view_of_all(Aabb{}, 0.8, 1.0)), eye, 1e-9)) << "nothing is as a cube of a metre";
}

TEST(view, near_plane_is_half_way_to_the_ball_around_the_scene_and_never_at_the_eye) {
  const Aabb box{{-1, 1, -4}, {3, 5, -2}};  // radius 3
  EXPECT_DOUBLE_EQ(near_plane_for({1, 3, 20}, box), 0.5 * (23.0 - 3.0));
  EXPECT_DOUBLE_EQ(near_plane_for({1, 3, 1000.0}, box), 500.0);
  for (const glm::dvec3 within : {glm::dvec3(1, 3, -3), {2, 4, -3}, {1, 3, 0.005}})
    EXPECT_DOUBLE_EQ(near_plane_for(within, box), 0.006);
}

TEST(view, of_an_empty_or_flat_box_is_finite) {
  Aabb point;
  point.add({2.0f, 2.0f, 2.0f});
  for (const Aabb& box : {Aabb{}, point}) {
    const View view = view_of_all(box, 0.8, 1.5);
    EXPECT_TRUE(std::isfinite(view.view_from_world.row[0].w) && view.near_m > 0.0);
  }
}

/// True if a box around a point is out of view, looking along -z from the origin.
bool is_out(const View& view, const glm::vec3& middle, float half = 0.1f) {
  return is_out_of_view(view, 2.0, view.view_from_world, Aabb{middle - half, middle + half});
}

TEST(view, P14_a_box_is_out_of_view_when_it_lies_beyond_one_side) {
  View view = look_at({0, 0, 0}, {0, 0, -1}, 2.0 * std::atan(0.5), 1.0);  // at distance 10: 10 high, 20 wide
  EXPECT_FALSE(is_out(view, {0, 0, -10}));
  EXPECT_FALSE(is_out(view, {10.05f, 0, -10}) || is_out(view, {-10.05f, 0, -10}));
  EXPECT_TRUE(is_out(view, {10.3f, 0, -10}) && is_out(view, {-10.3f, 0, -10}));
  EXPECT_FALSE(is_out(view, {0, 5.05f, -10}) || is_out(view, {0, -5.05f, -10}));
  EXPECT_TRUE(is_out(view, {0, 5.3f, -10}) && is_out(view, {0, -5.3f, -10}));
  EXPECT_TRUE(is_out(view, {0, 0, -0.8f}) && is_out(view, {0, 0, 10})) << "before the near plane, behind the viewer";
  EXPECT_FALSE(is_out(view, {0, 0, -0.95f}));
  EXPECT_FALSE(is_out(view, {0, 0, -1e6f})) << "no far plane";
  view.far_m = 50.0;
  EXPECT_TRUE(is_out(view, {0, 0, -51}));
  EXPECT_FALSE(is_out(view, {0, 0, -50}));
  EXPECT_FALSE(is_out(view, {0, 0, 0}, 100.0f)) << "the viewer is inside";
  EXPECT_FALSE(is_out_of_view(view, 2.0, view.view_from_world, {})) << "unknown size";
}

TEST(view, P14_a_parallel_view_is_as_wide_everywhere) {
  View view = look_at({0, 0, 0}, {0, 0, -1}, 0.8, 1.0);
  view.half_height_m = 2.0;
  view.far_m = 100.0;
  for (const float z : {-2.0f, -90.0f}) {
    EXPECT_FALSE(is_out(view, {4.05f, 2.05f, z}) || is_out(view, {-4.05f, -2.05f, z}));
    EXPECT_TRUE(is_out(view, {4.2f, 0, z}) && is_out(view, {0, -2.2f, z}));
  }
}

}  // namespace
}  // namespace sinew::viewer
