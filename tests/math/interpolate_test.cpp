// SPDX-License-Identifier: MIT
#include "runtime/math/interpolate.h"

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;
using test::kEps;
using test::same_rotation;

TEST(interpolate, step_holds_the_first_key_until_the_second) {
  EXPECT_EQ(step(1.f, 2.f, 0.999f), 1.f);
  EXPECT_EQ(step(1.f, 2.f, 1.f), 2.f);
}

TEST(interpolate, G06_every_curve_returns_its_keys_bit_for_bit) {
  FixedRandom random(1);
  for (int i = 0; i < 100; ++i) {
    const auto q = random.rotation(), r = random.rotation(), a = random.rotation(), b = random.rotation();
    EXPECT_EQ(slerp_short_arc(q, r, 0.f), q);
    EXPECT_EQ(slerp_short_arc(q, r, 1.f), r);
    EXPECT_EQ(nlerp_short_arc(q, r, 0.f), q);
    EXPECT_EQ(nlerp_short_arc(q, r, 1.f), r);
    EXPECT_EQ(hermite_rotation(q, a, b, r, 0.f, 1e6f), q);
    EXPECT_EQ(hermite_rotation(q, a, b, r, 1.f, 1e6f), r);
    const auto u = random.vec3(), v = random.vec3();
    EXPECT_EQ(lerp(u, v, 0.f), u);
    EXPECT_EQ(lerp(u, v, 1.f), v);
    EXPECT_EQ(hermite(u, u, v, v, 1.f, 3.f), v);
  }
}

TEST(interpolate, N01_slerp_of_tiny_angles_keeps_its_relative_accuracy) {
  FixedRandom random(2);
  for (double angle = 1e-7; angle < 3.0; angle *= 1.7) {
    const auto q = random.rotation<double>(), turn = random.rotation_by<double>(angle);
    for (const double t : {0.1, 0.5, 0.9})
      EXPECT_NEAR(rotation_angle_between(q, slerp_short_arc(q, q * turn, t)), t * angle, 2e-15) << angle;
  }
}

TEST(interpolate, N01_slerp_of_equal_keys_is_the_key) {
  FixedRandom random(3);
  const auto q = random.rotation();
  EXPECT_EQ(slerp_short_arc(q, q, 0.3f), q);
  EXPECT_TRUE(same_rotation(slerp_short_arc(q, -q, 0.3f), q, 4 * kEps));
}

TEST(interpolate, N02_slerp_takes_the_short_arc_and_q_and_minus_q_agree) {
  FixedRandom random(4);
  for (int i = 0; i < 300; ++i) {
    const auto q = random.rotation(), r = random.rotation();
    const auto t = static_cast<float>(random.unit());
    const double whole = test::angle_between(q, r);
    const auto s = slerp_short_arc(q, r, t);
    EXPECT_NEAR(test::angle_between(q, s), t * whole, 8 * kEps);
    if (std::abs(quat_dot(q, r)) < 1e-6f) continue;  // half a turn apart: both arcs are equally short
    EXPECT_TRUE(same_rotation(s, slerp_short_arc(q, -r, t), 8 * kEps));
  }
}

TEST(interpolate, N02_slerp_along_the_given_arc_survives_opposite_keys) {
  FixedRandom random(5);
  const auto q = random.rotation();
  Quat<float> last = q;
  for (int i = 1; i <= 100; ++i) {
    const auto s = slerp_as_given(q, -q, static_cast<float>(i) / 100);
    EXPECT_NEAR(test::angle_between(last, s), 2 * 3.14159265 / 100, 1e-5) << i;
    last = s;
  }
}

TEST(interpolate, N02_nlerp_of_opposite_keys_is_the_key_not_zero) {
  FixedRandom random(6);
  const auto q = random.rotation();
  EXPECT_TRUE(same_rotation(nlerp_short_arc(q, -q, 0.5f), q, 4 * kEps));
}

TEST(interpolate, N04_nlerp_error_grows_as_the_table_says) {
  const struct {
    double degrees, error_degrees;
  } rows[] = {{5, 0.00015}, {20, 0.0098}, {45, 0.112}, {90, 0.919}, {150, 4.51}};
  FixedRandom random(7);
  for (const auto& row : rows) {
    const double angle = row.degrees * 3.141592653589793 / 180;
    const auto q = random.rotation<double>(), r = q * random.rotation_by<double>(angle);
    double worst = 0;
    for (double t = 0; t <= 1; t += 0.0005)
      worst = std::max(worst, rotation_angle_between(nlerp_short_arc(q, r, t), slerp_short_arc(q, r, t)));
    EXPECT_NEAR(worst * 180 / 3.141592653589793, row.error_degrees, 0.04 * row.error_degrees) << row.degrees;
  }
}

TEST(interpolate, hermite_has_the_slopes_it_was_given) {
  const double td = 0.25, h = 1e-6;
  const auto value = [&](double s) { return hermite(2.0, 3.0, -5.0, 7.0, s, td); };
  EXPECT_NEAR((value(h) - value(0)) / (h * td), 3.0, 1e-3);
  EXPECT_NEAR((value(1) - value(1 - h)) / (h * td), -5.0, 1e-3);
  EXPECT_DOUBLE_EQ(value(0.5), 0.5 * (2 + 7) + td / 8 * (3 - -5));
}

TEST(interpolate, hermite_rotation_without_direction_falls_back_to_the_nearer_key) {
  const auto q = quat_xyzw(0.f, 0.f, 0.f, 1.f), zero = quat_xyzw(0.f, 0.f, 0.f, 0.f);
  EXPECT_EQ(hermite_rotation(q, zero, zero, -q, 0.5f, 1.f), -q);
  EXPECT_EQ(hermite_rotation(zero, zero, zero, q, 0.25f, 1.f), q);
}

}  // namespace
}  // namespace sinew
