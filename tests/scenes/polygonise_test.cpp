// SPDX-License-Identifier: MIT
#include "samples/showcase/polygonise.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/scenes/closed_surface.h"

namespace sinew::test {
namespace {

using showcase::polygonise;

const Aabb kRoom{glm::vec3(-3.0f), glm::vec3(3.0f)};

TEST(polygonise, makes_a_ball_that_is_closed_round_and_smooth) {
  const glm::vec3 centre(0.1f, -0.2f, 0.3f);
  const Primitive ball = polygonise([&](const glm::vec3& p) { return glm::distance(p, centre) - 1.0f; }, kRoom, 0.1f);
  EXPECT_EQ(open_edges(ball), 0u);
  EXPECT_EQ(euler_number(ball), 2);
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    const glm::vec3 out = ball.positions[v] - centre;
    ASSERT_NEAR(glm::length(out), 1.0f, 1e-4f);
    ASSERT_GT(glm::dot(ball.normals[v], out), 0.9999f);
  }
  double area = 0.0;
  for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
    const auto corner = [&](std::size_t c) { return ball.positions[ball.indices[i + c]]; };
    const glm::vec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    ASSERT_GT(glm::dot(normal, corner(0) - centre), 0.0f) << "counter-clockwise from outside";
    area += 0.5 * static_cast<double>(glm::length(normal));
  }
  EXPECT_NEAR(area / (4.0 * std::numbers::pi), 1.0, 0.01);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(ball.bounds.lower[axis], centre[axis] - 1.0f, 0.01f);
    EXPECT_NEAR(ball.bounds.upper[axis], centre[axis] + 1.0f, 0.01f);
  }
}

TEST(polygonise, skipped_blocks_contain_no_surface) {
  const auto balls = [](const glm::vec3& p) {
    return std::min(glm::distance(p, glm::vec3(-2.6f, 2.5f, -2.4f)), glm::distance(p, glm::vec3(2.5f, -2.3f, 2.6f))) -
           0.15f;
  };
  const Primitive two = polygonise(balls, kRoom, 0.1f);
  EXPECT_EQ(open_edges(two), 0u);
  EXPECT_EQ(euler_number(two), 4) << "two spheres";
}

TEST(polygonise, asks_near_the_surface_only) {
  int asked = 0;
  const auto ball = [&](const glm::vec3& p) {
    ++asked;
    return glm::length(p) - 1.0f;
  };
  const Primitive surface = polygonise(ball, kRoom, 0.1f);
  EXPECT_LT(asked, 61 * 61 * 61 / 4);
  EXPECT_TRUE(polygonise([](const glm::vec3&) { return 1.0f; }, kRoom, 0.5f).positions.empty());
}

}  // namespace
}  // namespace sinew::test
