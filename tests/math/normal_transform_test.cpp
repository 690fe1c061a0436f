// SPDX-License-Identifier: MIT
#include "runtime/math/normal_transform.h"

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;
using test::kEps;

TEST(normal_transform, N22_normal_of_moved_edges_is_the_moved_normal) {
  FixedRandom random(1);
  for (int i = 0; i < 200; ++i) {
    const Mat3<double> m(random.vec3<double>(), random.vec3<double>(), random.vec3<double>());
    const auto a = random.vec3<double>(), b = random.vec3<double>();
    const auto expected = normalised_or(glm::cross(m * a, m * b), Vec3<double>(0));
    EXPECT_TRUE(is_near(transform_normal(m, glm::cross(a, b)), expected, 1e-11));
  }
}

TEST(normal_transform, N22_flattened_surface_keeps_the_normal_of_the_flat) {
  const Mat3<float> flat(2, 0, 0, 0, 3, 0, 0, 0, 0);
  EXPECT_TRUE(is_near(transform_normal(flat, Vec3<float>(0, 0.6f, 0.8f)), Vec3<float>(0, 0, 1), 0));
}

TEST(normal_transform, N22_no_normal_left_keeps_the_old_one) {
  const Vec3<float> n(0, 0.6f, 0.8f);
  EXPECT_EQ(transform_normal(Mat3<float>(0.f), n), n);
  EXPECT_EQ(transform_normal_outward(Mat3<float>(0.f), n), n);
}

TEST(normal_transform, N22_holds_at_scales_whose_squares_overflow_or_vanish) {
  FixedRandom random(2);
  for (const float size : {1e-30f, 1e-20f, 1e20f, 1e30f}) {
    const auto n = random.direction();
    EXPECT_TRUE(is_near(transform_normal(Mat3<float>(size), n), n, 4 * kEps)) << size;
    EXPECT_TRUE(is_near(transform_normal_outward(Mat3<float>(-size), n), -n, 4 * kEps)) << size;
  }
}

TEST(normal_transform, G48_outward_normal_flips_with_the_winding_of_a_mirror) {
  Mat3<float> mirror(1.f);
  mirror[0][0] = -1;
  EXPECT_TRUE(is_near(transform_normal(mirror, Vec3<float>(0, 1, 0)), Vec3<float>(0, -1, 0), 0));
  EXPECT_TRUE(is_near(transform_normal_outward(mirror, Vec3<float>(0, 1, 0)), Vec3<float>(0, 1, 0), 0));
}

}  // namespace
}  // namespace sinew
