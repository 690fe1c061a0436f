// SPDX-License-Identifier: MIT
#include "runtime/math/normal_transform.h"

#include "runtime/math/matrix_rotation.h"
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

TEST(normal_transform, G48_outward_normals_of_ill_conditioned_matrices_are_exact_to_float) {
  FixedRandom random(3);
  for (const Vec3<double> values : {Vec3<double>(1e3, 1e-3, 1e-3), Vec3<double>(1e-3, 1e3, -1e-3),
                                    Vec3<double>(1e9, -1, 1e-6), Vec3<double>(1, 1e-5, 1e-6)})
    for (int i = 0; i < 200; ++i) {
      Mat3<double> d(0.0);
      for (int c = 0; c < 3; ++c) d[c][c] = values[c];
      const Mat3<float> m(matrix_from_unit_quat(random.rotation<double>()) * d *
                          matrix_from_unit_quat(random.rotation<double>()));
      const auto n = random.direction();
      const Mat3<long double> exact(m);  // products of three entries need 72 bits; rounding is below 2^-64
      const long double determinant = glm::dot(exact[0], glm::cross(exact[1], exact[2]));
      const Vec3<long double> moved = cofactor(exact) * Vec3<long double>(n);
      const Vec3<double> truth(moved / std::sqrt(glm::dot(moved, moved)) * (determinant < 0.0L ? -1.0L : 1.0L));
      EXPECT_TRUE(is_near(Vec3<double>(transform_normal_outward(m, n)), truth, 2 * kEps)) << i;
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
