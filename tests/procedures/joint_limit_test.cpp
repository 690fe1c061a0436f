// SPDX-License-Identifier: MIT
#include "runtime/procedures/joint_limit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/base/same_bits.h"
#include "runtime/math/axis_angle.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

using V = Vec3<double>;
using Q = Quat<double>;

JointLimit random_limit(FixedRandom& random) {
  JointLimit limit;
  limit.center = random.rotation();
  limit.axes = random.rotation();
  limit.swing_y_rad = static_cast<float>(random.in(0.0, 2.5));
  limit.swing_z_rad = static_cast<float>(random.in(0.0, 2.5));
  limit.least_twist_rad = static_cast<float>(random.in(-2.0, 0.3));
  limit.most_twist_rad = static_cast<float>(random.in(0.3, 2.0));
  return limit;
}

/// The rotation in the axes of the limit.
Q in_axes(const JointLimit& limit, const Q& rotation) {
  const Q axes = normalised(quat_cast<double>(limit.axes));
  return quat_conjugate(normalised(quat_cast<double>(limit.center)) * axes) * rotation * axes;
}

/// Swing as a vector of rotation (0, y, z), by the direction of the bone alone.
V swing_of(const JointLimit& limit, const Q& rotation) {
  const V bone = rotate_vector(in_axes(limit, rotation), V(1, 0, 0));
  const double angle = std::atan2(safe_length(V(0, bone.y, bone.z)), bone.x);
  return normalised_or(glm::cross(V(1, 0, 0), bone), V(0)) * angle;
}

TEST(joint_limit, allowed_rotations_keep_their_bits) {
  JointLimit limit;
  limit.swing_y_rad = 0.5f;
  limit.swing_z_rad = 1.0f;
  limit.least_twist_rad = -0.3f;
  limit.most_twist_rad = 0.6f;
  const JointLimiter limiter(limit);
  FixedRandom random(1);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const double y = random.in(-0.6, 0.6), z = random.in(-1.1, 1.1), twist = random.in(-0.4, 0.7);
    const Q swing = quat_from_axis_angle(V(0, y, z), std::hypot(y, z));
    const Q q = swing * quat_from_axis_angle(V(1, 0, 0), twist);
    const double out = (y / 0.5) * (y / 0.5) + z * z;
    if (std::abs(out - 1) < 1e-6 || std::abs(twist + 0.3) < 1e-6 || std::abs(twist - 0.6) < 1e-6) continue;
    const bool allowed = out < 1 && twist > -0.3 && twist < 0.6;
    const LimitedRotation found = limiter(q);
    EXPECT_EQ(found.is_limited, !allowed) << y << ' ' << z << ' ' << twist;
    if (allowed) {
      EXPECT_TRUE(same_bits(found.rotation, q));
      ++inside;
    }
  }
  EXPECT_GT(inside, 5000);
}

TEST(joint_limit, results_are_within_the_limit) {
  FixedRandom random(2);
  for (int i = 0; i < 20000; ++i) {
    const JointLimit limit = random_limit(random);
    const LimitedRotation found = JointLimiter(limit)(random.rotation<double>());
    const V swing = swing_of(limit, found.rotation);
    const double a = static_cast<double>(limit.swing_y_rad), b = static_cast<double>(limit.swing_z_rad);
    EXPECT_LE(std::pow(swing.y / a, 2) + std::pow(swing.z / b, 2), 1 + 1e-6) << i;
    const Q q = in_axes(limit, found.rotation);
    const double twist = 2 * std::atan2(q.w < 0 ? -q.x : q.x, std::abs(q.w));
    EXPECT_GE(twist, static_cast<double>(limit.least_twist_rad) - 1e-7);
    EXPECT_LE(twist, static_cast<double>(limit.most_twist_rad) + 1e-7);
    EXPECT_NEAR(safe_length(found.rotation), 1.0, 1e-12);
  }
}

TEST(joint_limit, a_swing_beyond_the_cone_goes_to_the_nearest_point_of_the_ellipse) {
  JointLimit limit;
  limit.swing_y_rad = 0.5f;
  limit.swing_z_rad = 1.0f;
  limit.limits_twist = false;
  const JointLimiter limiter(limit);
  FixedRandom random(3);
  for (int i = 0; i < 500; ++i) {
    const V given(0, random.in(-2, 2), random.in(-2, 2));
    if (given.y * given.y * 4 + given.z * given.z < 1 || safe_length(given) > 2.8) continue;
    double best = 10;
    for (int k = 0; k < 20000; ++k) {
      const double at = k * std::numbers::pi / 10000;
      best = std::min(best, distance(given, V(0, 0.5 * std::cos(at), std::sin(at))));
    }
    const V found = swing_of(limit, limiter(quat_from_axis_angle(given, safe_length(given))).rotation);
    EXPECT_LE(distance(given, found), best + 1e-9) << given.y << ' ' << given.z;
  }
}

TEST(joint_limit, is_continuous_over_all_rotations_and_never_snaps_to_the_other_side) {
  FixedRandom random(4);
  double worst = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    const JointLimiter limiter(random_limit(random));
    const Q q = random.rotation<double>(), near = normalised(random.rotation_by<double>(1e-5) * q);
    worst = std::max(worst, angle_between(limiter(q).rotation, limiter(near).rotation));
  }
  EXPECT_LT(glm::degrees(worst), 0.1);
}

TEST(joint_limit, sweeps_through_the_places_opposite_to_the_center_are_continuous) {
  FixedRandom random(5);
  double worst = 0.0;
  for (int i = 0; i < 60; ++i) {
    const JointLimit limit = random_limit(random);
    const JointLimiter limiter(limit);
    const Q axes = normalised(quat_cast<double>(limit.axes));
    // Half a turn of swing, or the twist in the middle of those that are forbidden.
    const double twist = static_cast<double>(limit.least_twist_rad + limit.most_twist_rad) / 2 + std::numbers::pi;
    const Q away = i % 2 == 0 ? quat_from_axis_angle(V(0, random.in(-1, 1), random.in(-1, 1)), std::numbers::pi)
                              : quat_from_axis_angle(V(1, 0, 0), twist);
    const Q opposite = normalised(quat_cast<double>(limit.center)) * axes * away * quat_conjugate(axes);
    const V axis = random.direction<double>();
    Q last = quat_identity<double>();
    for (int k = -20000; k <= 20000; ++k) {  // the step is 1e-5
      const Q now = limiter(normalised(quat_from_axis_angle(axis, k * 1e-5) * opposite)).rotation;
      if (k > -20000) worst = std::max(worst, angle_between(last, now));
      last = now;
    }
  }
  EXPECT_LT(glm::degrees(worst), 0.1);
}

TEST(joint_limit, a_hundred_runs_have_the_same_bits_and_a_second_run_changes_nothing) {
  FixedRandom random(6);
  for (int i = 0; i < 200; ++i) {
    const JointLimiter limiter(random_limit(random));
    const Q q = random.rotation<double>();
    const Q first = limiter(q).rotation;
    for (int k = 0; k < 100; ++k) EXPECT_TRUE(same_bits(limiter(q).rotation, first));
    EXPECT_LT(angle_between(limiter(first).rotation, first), 1e-9) << "a projection";
  }
}

TEST(joint_limit, a_closed_limit_allows_its_center_alone) {
  JointLimit limit;
  FixedRandom random(7);
  limit.center = random.rotation();
  for (int i = 0; i < 100; ++i)
    EXPECT_LT(angle_between(JointLimiter(limit)(random.rotation<double>()).rotation, limit.center), 1e-7);
}

TEST(joint_limit, a_hinge_is_a_flat_cone) {
  JointLimit limit;
  limit.swing_y_rad = 1.0f;
  const JointLimiter limiter(limit);
  FixedRandom random(8);
  for (int i = 0; i < 1000; ++i) {
    const Q found = limiter(random.rotation<double>()).rotation;
    EXPECT_LT(std::abs(found.x) + std::abs(found.z), 1e-12);
    EXPECT_LE(std::abs(2 * std::asin(found.y)), 1 + 1e-9);
  }
}

TEST(joint_limit, refuses_angles_for_which_it_is_not_continuous) {
  JointLimit limit;
  EXPECT_EQ(check(limit), ErrorCode::ok);
  limit.swing_y_rad = 2.9f;
  EXPECT_EQ(check(limit), ErrorCode::too_large);
  limit.limits_swing = false;
  EXPECT_EQ(check(limit), ErrorCode::ok);
  limit.least_twist_rad = 0.5f;
  EXPECT_EQ(check(limit), ErrorCode::too_large) << "the interval is upside down";
  limit = {};
  limit.axes.w = 2.0f;
  EXPECT_EQ(check(limit), ErrorCode::not_normalised);
  limit.axes.w = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(check(limit), ErrorCode::not_finite);
}

}  // namespace
}  // namespace sinew::test
