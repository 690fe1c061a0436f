// SPDX-License-Identifier: MIT
#include "importer/ambient/visibility_rays.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

glm::dvec3 random_normal(test::FixedRandom& random) {
  return glm::normalize(glm::dvec3(random.normal(), random.normal(), random.normal()));
}

TEST(visibility_rays, N34_directions_are_unit_in_the_hemisphere_and_have_the_moments_of_the_cosine) {
  // With density cos / pi, mean cos = 2/3 and mean cos^2 = 1/2. The two other coordinates have mean 0 and mean square
  // 1/4.
  test::FixedRandom random(7);
  for (int round = 0; round < 20; ++round) {
    const glm::dvec3 n = random_normal(random);
    constexpr std::uint32_t kRays = 1024;
    const VisibilityRays rays(n, kRays, visibility_shift(3, static_cast<std::uint64_t>(round)));
    glm::dvec3 sum(0.0);
    double cos2 = 0.0;
    for (std::uint32_t i = 0; i < kRays; ++i) {
      const glm::dvec3 d = rays.direction(i);
      ASSERT_NEAR(glm::length(d), 1.0, 1e-14);
      ASSERT_GE(glm::dot(d, n), 0.0);
      sum += d / double{kRays};
      cos2 += glm::dot(d, n) * glm::dot(d, n) / kRays;
    }
    EXPECT_LT(glm::length(sum - n * (2.0 / 3.0)), 4e-3);
    EXPECT_NEAR(cos2, 0.5, 1e-3);
  }
}

TEST(visibility_rays, any_disc_of_directions_has_its_share_of_the_rays) {
  // Projected along the normal, the rays cover the unit disc evenly: a quarter of the area has a quarter of them.
  const VisibilityRays rays({0, 1, 0}, 4096, visibility_shift(1, 0));
  int inner = 0, wedge = 0;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    const glm::dvec3 d = rays.direction(i);
    inner += d.x * d.x + d.z * d.z < 0.25;
    wedge += d.x > 0.0 && d.z > 0.0;
  }
  EXPECT_NEAR(inner, 1024, 2);
  EXPECT_NEAR(wedge, 1024, 30);
}

TEST(visibility_rays, each_seed_and_each_corner_has_a_shift_of_its_own) {
  std::set<double> all;
  for (std::uint64_t seed = 0; seed < 8; ++seed)
    for (std::uint64_t corner = 0; corner < 1000; ++corner) {
      const glm::dvec2 shift = visibility_shift(seed, corner);
      ASSERT_TRUE(shift.x >= 0.0 && shift.x < 1.0 && shift.y >= 0.0 && shift.y < 1.0);
      all.insert(shift.x);
      all.insert(shift.y);
    }
  EXPECT_EQ(all.size(), 16000u);
}

TEST(visibility_rays, they_start_above_the_triangle_by_more_than_floats_round) {
  test::FixedRandom random(11);
  for (int round = 0; round < 200; ++round) {
    const double size = std::exp(random.in(-6, 6)), far = std::exp(random.in(-3, 8));
    glm::dvec3 corners[3];
    const auto offset = random.vec3<double>();
    for (glm::dvec3& c : corners) c = glm::dvec3(glm::vec3(offset * far + random.vec3<double>() * size));
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (glm::length(across) < 0.1 * size * size) continue;
    const glm::dvec3 n = glm::normalize(across), middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const glm::dvec3 start(glm::vec3(visibility_start(corners[0], middle, n)));
    EXPECT_GT(glm::dot(start - corners[0], n), 0.0) << size << ' ' << far;
    if (far < 10.0 * size) {
      EXPECT_LT(glm::dot(start - corners[0], n), 1e-3 * size);
    }
  }
}

}  // namespace
}  // namespace sinew
