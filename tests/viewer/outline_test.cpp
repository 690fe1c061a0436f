// SPDX-License-Identifier: MIT
#include "viewer/app/pictures/outline.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

TEST(outline, is_empty_before_the_first_point_and_then_holds_only_points_that_were_added) {
  Outline outline;
  EXPECT_TRUE(outline.points().empty());
  outline.add({1, 2, 3});
  ASSERT_FALSE(outline.points().empty());
  for (const auto& p : outline.points()) EXPECT_EQ(p, glm::vec3(1, 2, 3));
}

TEST(outline, keeps_outer_points_and_forgets_inner_ones) {
  Outline outline;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      for (int z = -3; z <= 3; ++z) outline.add(glm::vec3(x, y, z) + glm::vec3(100, 0, 0));
  for (const auto& p : outline.points()) EXPECT_EQ(std::max({std::abs(p.x - 100), std::abs(p.y), std::abs(p.z)}), 3.0f);
}

TEST(outline, reaches_nearly_as_far_as_a_ball_in_every_direction) {
  constexpr int kSteps = 60;
  const auto on_ball = [](double height, double angle) {
    const double radius = std::sqrt(1.0 - height * height);
    return glm::vec3(glm::dvec3(radius * std::cos(angle), height, radius * std::sin(angle)));
  };
  Outline outline;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j < 2 * kSteps; ++j) outline.add(on_ball(1.0 - 2.0 * i / kSteps, 3.14159265 * j / kSteps));
  for (int i = 0; i <= 17; ++i)
    for (int j = 0; j < 31; ++j) {
      const glm::vec3 direction = on_ball(1.0 - 2.0 * i / 17, 6.2831853 * j / 31);
      float reach = 0.0f;
      for (const auto& p : outline.points()) reach = std::max(reach, glm::dot(p, direction));
      EXPECT_GT(reach, 0.92f);
    }
}

}  // namespace
}  // namespace sinew::viewer
