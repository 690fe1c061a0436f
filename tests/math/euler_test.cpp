// SPDX-License-Identifier: MIT
#include "runtime/math/euler.h"

#include "runtime/math/matrix_rotation.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::kEps;

constexpr double kPi = 3.141592653589793;

template <class T>
double distance(const Mat3<T>& a, const Mat3<T>& b) {
  double worst = 0;
  for (int c = 0; c < 3; ++c) worst = std::max(worst, test::distance(a[c], b[c]));
  return worst;
}

TEST(euler, head_pitch_roll_is_the_product_of_its_three_rotations) {
  FixedRandom random(1);
  for (int i = 0; i < 100; ++i) {
    const HeadPitchRollT<double> e{random.in(-4, 4), random.in(-4, 4), random.in(-4, 4)};
    const auto product =
        rotation_about_axis(2, e.roll_rad) * rotation_about_axis(0, e.pitch_rad) * rotation_about_axis(1, e.head_rad);
    EXPECT_LE(distance(matrix_from_head_pitch_roll(e), product), 1e-15);
    EXPECT_LE(distance(matrix_from_unit_quat(quat_from_head_pitch_roll(e)), product), 2e-15);
  }
}

TEST(euler, N13_extraction_rebuilds_the_matrix_at_and_around_gimbal_lock) {
  FixedRandom random(2);
  for (const double away : {0.0, 1e-8, 1e-7, 3e-4, 1e-3, 0.01, 0.3})
    for (const double side : {-1.0, 1.0})
      for (int i = 0; i < 50; ++i) {
        const HeadPitchRollT<double> e{random.in(-3, 3), side * (kPi / 2 - away), random.in(-3, 3)};
        const auto m = Mat3<float>(matrix_from_head_pitch_roll(e));
        const auto found = head_pitch_roll_from_matrix(m);
        EXPECT_LE(distance(matrix_from_head_pitch_roll(found), m), 16 * kEps) << away;
      }
}

TEST(euler, N13_extraction_survives_a_sine_above_one) {
  Mat3<float> m = matrix_from_head_pitch_roll(HeadPitchRollT<float>{0.3f, static_cast<float>(kPi / 2), 0.0f});
  m[1][2] = 1.0000001f;
  const auto found = head_pitch_roll_from_matrix(m);
  EXPECT_LE(distance(matrix_from_head_pitch_roll(found), m), 16 * kEps);
}

TEST(euler, all_24_orders_are_different_and_rebuild_random_rotations) {
  FixedRandom random(3);
  const Vec3<double> angles(0.4, 0.7, 1.1);
  for (int i = 0; i < 24; ++i) {
    for (int j = 0; j < i; ++j) {
      const auto a = matrix_from_euler(kEulerOrders[i], angles), b = matrix_from_euler(kEulerOrders[j], angles);
      EXPECT_GT(distance(a, b), 0.05) << i << " " << j;
    }
    for (int k = 0; k < 50; ++k) {
      const auto m = matrix_from_unit_quat(random.rotation<double>());
      EXPECT_LE(distance(matrix_from_euler(kEulerOrders[i], euler_from_matrix(kEulerOrders[i], m)), m), 1e-14) << i;
    }
  }
}

TEST(euler, angles_come_back_away_from_the_lock) {
  FixedRandom random(4);
  for (const EulerOrder& order : kEulerOrders) {
    const bool repeated = order.axes[0] == order.axes[2];
    for (int k = 0; k < 20; ++k) {
      const double middle = repeated ? random.in(0.1, 3.0) : random.in(-1.4, 1.4);
      const Vec3<double> angles(random.in(-3, 3), middle, random.in(-3, 3));
      EXPECT_TRUE(test::is_near(euler_from_matrix(order, matrix_from_euler(order, angles)), angles, 1e-13));
    }
  }
}

TEST(euler, N13_all_24_orders_rebuild_at_their_own_gimbal_lock) {
  FixedRandom random(5);
  for (const EulerOrder& order : kEulerOrders) {
    const bool repeated = order.axes[0] == order.axes[2];
    for (const double away : {0.0, 1e-8, 1e-5, 1e-3})
      for (const double lock : {0.0, kPi}) {
        const double middle = (repeated ? lock : kPi / 2 - lock) + away;
        const auto m = Mat3<float>(matrix_from_euler(order, Vec3<double>(random.in(-3, 3), middle, random.in(-3, 3))));
        EXPECT_LE(distance(matrix_from_euler(order, euler_from_matrix(order, m)), m), 24 * kEps) << away;
      }
  }
}

TEST(rotation_about, point_on_the_axis_stays_in_place) {
  FixedRandom random(6);
  const auto p = random.vec3<double>(), other = random.vec3<double>();
  const auto r = rotation_about_axis(1, 0.7);
  const auto m = about_point(r, p);
  EXPECT_TRUE(test::is_near(transform_point(m, p), p, 1e-15));
  EXPECT_TRUE(test::is_near(transform_point(m, other), p + r * (other - p), 1e-15));
}

TEST(rotation_about, quarter_turns_go_x_to_y_to_z_to_x) {
  const Vec3<double> axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(test::is_near(rotation_about_axis(i, kPi / 2) * axes[(i + 1) % 3], axes[(i + 2) % 3], 1e-15));
}

}  // namespace
}  // namespace sinew
