// SPDX-License-Identifier: MIT
#include "runtime/math/axis_angle.h"

#include "runtime/math/matrix_rotation.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;
using test::kEps;

TEST(axis_angle, quaternion_and_matrix_agree) {
  FixedRandom random(1);
  for (int i = 0; i < 100; ++i) {
    const auto axis = random.vec3<double>();
    const double angle = random.in(-10, 10);
    const auto a = matrix_from_axis_angle(axis, angle), b = matrix_from_unit_quat(quat_from_axis_angle(axis, angle));
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(is_near(a[c], b[c], 2e-15));
  }
}

TEST(axis_angle, N11_axis_of_a_tiny_rotation_is_unit_and_right) {
  FixedRandom random(2);
  for (const float angle : {1e-37f, 1e-20f, 1e-7f, 5e-4f, 1e-3f, 0.1f, 3.1f}) {
    const auto axis = random.direction();
    const auto found = axis_angle_from_quat(quat_from_axis_angle(axis, angle));
    EXPECT_TRUE(is_near(found.axis, axis, 8 * kEps)) << angle;
    EXPECT_NEAR(found.angle_rad / angle, 1, 8 * kEps) << angle;
  }
}

TEST(axis_angle, negated_quaternion_gives_the_same_axis_and_angle) {
  FixedRandom random(3);
  const auto q = random.rotation();
  const auto a = axis_angle_from_quat(q), b = axis_angle_from_quat(-q);
  EXPECT_EQ(a.axis, b.axis);
  EXPECT_EQ(a.angle_rad, b.angle_rad);
  EXPECT_LE(a.angle_rad, 3.1415928f);
}

TEST(axis_angle, N11_no_rotation_and_no_axis_have_defined_answers) {
  EXPECT_EQ(axis_angle_from_quat(quat_identity<float>()).axis, Vec3<float>(1, 0, 0));
  EXPECT_EQ(axis_angle_from_quat(quat_identity<float>()).angle_rad, 0.f);
  EXPECT_EQ(quat_from_axis_angle(Vec3<float>(0), 1.f), quat_identity<float>());
  EXPECT_EQ(matrix_from_axis_angle(Vec3<float>(0), 1.f), Mat3<float>(1.f));
}

}  // namespace
}  // namespace sinew
