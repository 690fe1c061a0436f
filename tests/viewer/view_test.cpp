// SPDX-License-Identifier: MIT
#include "viewer/passes/view.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

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

TEST(view, of_an_empty_or_flat_box_is_finite) {
  Aabb point;
  point.add({2.0f, 2.0f, 2.0f});
  for (const Aabb& box : {Aabb{}, point}) {
    const View view = view_of_all(box, 0.8, 1.5);
    EXPECT_TRUE(std::isfinite(view.view_from_world.row[0].w) && view.near_m > 0.0);
  }
}

TEST(view, N30_reversed_depth_resolves_a_tenth_of_a_millimetre_at_a_kilometre) {
  const auto depth = [](double distance) { return 0.1f / static_cast<float>(distance); };  // stored = near / distance
  EXPECT_NE(depth(1000.0), depth(1000.00015));
  const auto back = 0.1 / static_cast<double>(depth(1000.0));
  EXPECT_NEAR(back, 1000.0, 1e-4);
}

}  // namespace
}  // namespace sinew::viewer
