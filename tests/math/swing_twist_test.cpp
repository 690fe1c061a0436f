// SPDX-License-Identifier: MIT
#include "runtime/math/swing_twist.h"

#include <gtest/gtest.h>

#include "runtime/math/axis_angle.h"
#include "runtime/math/rotation_between.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using Vec3d = Vec3<double>;
using Quatd = Quat<double>;
constexpr double kPi = 3.14159265358979323846;

/// A rotation with a given twist about `axis`, followed by a swing by `swing_rad`.
Quatd swung(test::FixedRandom& random, const Vec3d& axis, double swing_rad, double twist_rad) {
  const Vec3d across = rotate_vector(quat_from_axis_angle(axis, random.in(0, 6)), perpendicular_to(axis));
  return quat_from_axis_angle(across, swing_rad) * quat_from_axis_angle(axis, twist_rad);
}

TEST(swing_twist, each_angle_sees_its_own_part_only) {
  test::FixedRandom random(1);
  for (int i = 0; i < 500; ++i) {
    const Vec3d axis = random.direction<double>();
    const double twist = random.in(-kPi, kPi), swing = random.in(0, 3);
    const Quatd q = swung(random, axis, swing, twist), none = quat_identity<double>();
    EXPECT_NEAR(swing_angle_between(none, q, axis), swing, 1e-13);
    EXPECT_NEAR(twist_angle_between(none, q, axis), std::abs(twist), 1e-12);
    EXPECT_NEAR(swing_angle_between(q, q * quat_from_axis_angle(axis, 1.0), axis), 0.0, 1e-14);
  }
}

TEST(swing_twist, angles_are_symmetric_and_blind_to_signs) {
  test::FixedRandom random(2);
  for (int i = 0; i < 200; ++i) {
    const Vec3d axis = random.direction<double>();
    const Quatd q = random.rotation<double>(), r = random.rotation<double>();
    EXPECT_EQ(swing_angle_between(q, r, axis), swing_angle_between(-q, r, axis));
    EXPECT_EQ(twist_angle_between(q, r, axis), twist_angle_between(q, -r, axis));
    EXPECT_EQ(twist_angle_between(q, r, axis), twist_angle_between(r, q, axis));
    EXPECT_EQ(swing_angle_between(q, -q, axis), 0.0);
    EXPECT_EQ(twist_angle_between(q, -q, axis), 0.0);
    EXPECT_EQ(rotation_angle_between(q, -q), 0.0);
  }
}

TEST(swing_twist, N03_tiny_angles_keep_their_digits) {
  const Vec3d axis(0, 0, 1);
  for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12}) {
    EXPECT_NEAR(twist_angle_between(quat_identity<double>(), quat_from_axis_angle(axis, angle), axis), angle,
                1e-15 * angle);
    EXPECT_NEAR(swing_angle_between(quat_identity<double>(), quat_from_axis_angle(Vec3d(1, 0, 0), angle), axis), angle,
                1e-15 * angle);
  }
}

TEST(swing_twist, a_reversed_axis_has_no_twist_and_gives_no_nan) {
  const Quatd reversed = quat_xyzw(1.0, 0.0, 0.0, 0.0);
  EXPECT_EQ(twist_angle_between(reversed, quat_identity<double>(), Vec3d(0, 0, 1)), 0.0);
  EXPECT_NEAR(swing_angle_between(reversed, quat_identity<double>(), Vec3d(0, 0, 1)), kPi, 1e-15);
}

}  // namespace
}  // namespace sinew
