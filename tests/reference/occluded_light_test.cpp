// SPDX-License-Identifier: MIT
// Scattered ambient light on floors with walls under a white sky: the fitted cubic, compared with traced light paths.
#include "tests/reference/occluded_light.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/reference/rooms.h"

namespace sinew::reference {
namespace {

Paths paths_to_sky(const std::vector<RayTriangle>& triangles, const glm::dvec3& from, test::FixedRandom& random) {
  constexpr int count = 1500;
  Paths out{};
  for (int i = 0; i < count; ++i) add_path(triangles, from, scattered({0, 1, 0}, random), 1.0 / count, random, out);
  return out;
}

TEST(scattered_visibility, is_nearer_to_paths_of_light_than_visibility_alone) {
  test::FixedRandom random(3);
  std::vector<Paths> points;
  for (const std::vector<RayTriangle>& triangles :
       {room(2.0, false, false), room(1.0, true, false), room(1.5, false, true), room(0.7, true, true)})
    for (int i = 0; i < 15; ++i)
      points.push_back(paths_to_sky(triangles, {random.in(-0.99, 0.99), 1e-9, random.in(-0.99, 1.5)}, random));
  for (const double albedo : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    double with = 0.0, without = 0.0;
    for (const Paths& paths : points) {
      const double truth = light_of(paths, albedo);
      with += std::pow(scattered_visibility(paths[0], glm::dvec3(albedo)).x - truth, 2.0);
      without += std::pow(paths[0] - truth, 2.0);
    }
    EXPECT_LT(with, 0.4 * without) << albedo;
    EXPECT_LT(std::sqrt(with / static_cast<double>(points.size())), 0.06) << albedo;
  }
}

TEST(scattered_visibility, keeps_dark_and_light_and_takes_colour_from_the_surface) {
  EXPECT_EQ(scattered_visibility(1.0, {1.0, 0.5, 0.0}), glm::dvec3(1.0));
  EXPECT_EQ(scattered_visibility(0.0, {1.0, 0.5, 0.0}), glm::dvec3(0.0));
  const glm::dvec3 half = scattered_visibility(0.5, {0.9, 0.5, 0.0});
  EXPECT_EQ(half.b, 0.5);
  EXPECT_GT(half.r, half.g + 0.05);
  EXPECT_GT(half.g, half.b + 0.05);
}

}  // namespace
}  // namespace sinew::reference
