// SPDX-License-Identifier: MIT
#include "runtime/math/quat_log_exp.h"

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;
using test::same_rotation;

TEST(quat_log_exp, N07_exp_of_zero_is_the_identity) {
  EXPECT_EQ(quat_exp(Vec3<float>(0)), quat_identity<float>());
  EXPECT_EQ(quat_log(quat_identity<float>()), Vec3<float>(0));
}

TEST(quat_log_exp, N10_log_near_minus_one_keeps_its_axis_and_has_length_pi_there) {
  EXPECT_NEAR(safe_length(quat_log(quat_xyzw(0.0, 0.0, 0.0, -1.0))), 3.141592653589793, 1e-15);
  const auto v = quat_log(quat_xyzw(0.0, 1e-200, 0.0, -1.0));
  EXPECT_TRUE(is_near(v, Vec3<double>(0, 3.141592653589793, 0), 1e-15));
}

TEST(quat_log_exp, N11_log_of_tiny_rotations_keeps_its_relative_accuracy) {
  FixedRandom random(3);
  for (const double angle : {1e-30, 1e-12, 1e-7, 5e-4, 1e-3, 0.1}) {
    const auto q = random.rotation_by(angle);
    EXPECT_NEAR(safe_length(quat_log(q)) / (angle / 2), 1, 4 * test::kEps) << angle;
  }
}

TEST(quat_log_exp, exp_of_log_is_the_quaternion_with_its_sign) {
  FixedRandom random(1);
  for (int i = 0; i < 200; ++i) {
    const auto q = random.rotation<double>(), r = quat_exp(quat_log(q));
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(q[c], r[c], 1e-15);
  }
}

TEST(quat_log_exp, powers_add_and_the_inverse_is_power_minus_one) {
  FixedRandom random(2);
  for (int i = 0; i < 100; ++i) {
    const auto q = random.rotation<double>();
    EXPECT_TRUE(same_rotation(quat_pow(q, 0.3) * quat_pow(q, 1.2), quat_pow(q, 1.5), 1e-14));
    EXPECT_TRUE(same_rotation(quat_pow(q, -1.0), quat_conjugate(q), 1e-14));
  }
}

}  // namespace
}  // namespace sinew
