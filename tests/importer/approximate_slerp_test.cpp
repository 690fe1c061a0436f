// SPDX-License-Identifier: MIT
#include "importer/tool/cost/rotation/approximate_slerp.h"

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew::cost {
namespace {

using test::FixedRandom;
using test::kEps;

constexpr double kDegrees = 180 / 3.141592653589793;

template <class T, class Blend>
double worst_error_rad(double angle_rad, Blend blend) {
  FixedRandom random(1);
  double worst = 0;
  for (int i = 0; i < 20; ++i) {
    const auto q = random.rotation<double>(), r = q * random.rotation_by<double>(angle_rad);
    for (double t = 0; t <= 1; t += 0.01)
      worst = std::max(worst, test::angle_between(blend(quat_cast<T>(q), quat_cast<T>(r), static_cast<T>(t)),
                                                  slerp_short_arc(q, r, t)));
  }
  return worst;
}

TEST(approximate_slerp, N05_corrected_nlerp_keeps_the_stated_error) {
  const struct {
    double degrees, allowed_degrees;
  } rows[] = {{20, 0.0005}, {45, 0.001}, {90, 0.003}, {150, 0.021}, {179.9, 0.036}};
  for (const auto& row : rows) {
    const double worst = worst_error_rad<double>(row.degrees / kDegrees, corrected_nlerp<double>) * kDegrees;
    EXPECT_LE(worst, row.allowed_degrees) << row.degrees;
    EXPECT_GE(worst, row.allowed_degrees / 4) << row.degrees << ": the stated error is stale";
  }
}

TEST(approximate_slerp, N05_correction_leaves_ends_and_middle_alone) {
  for (const double d : {0.0, 0.3, 0.9, 1.0})
    for (const double t : {0.0, 0.5, 1.0}) EXPECT_EQ(corrected_parameter(t, d), t);
}

TEST(approximate_slerp, N06_polynomial_holds_1e_8_in_double_at_every_angle) {
  for (const double degrees : {0.0, 0.1, 5.0, 45.0, 90.0, 150.0, 179.9, 180.0})
    EXPECT_LE(worst_error_rad<double>(degrees / kDegrees, polynomial_slerp<double>), 1e-8) << degrees;
}

TEST(approximate_slerp, N06_polynomial_in_float_is_as_good_as_slerp) {
  for (const double degrees : {0.1, 5.0, 45.0, 90.0, 150.0, 179.9}) {
    EXPECT_LE(worst_error_rad<float>(degrees / kDegrees, polynomial_slerp<float>), 4e-7) << degrees;
    EXPECT_LE(worst_error_rad<float>(degrees / kDegrees, slerp_short_arc<float>), 4e-7) << degrees;
  }
}

TEST(approximate_slerp, N06_polynomial_stays_unit_without_a_square_root_at_the_end) {
  FixedRandom random(2);
  for (int i = 0; i < 1000; ++i) {
    const auto q = polynomial_slerp(random.rotation<double>(), random.rotation<double>(), random.unit());
    EXPECT_NEAR(safe_length(q), 1, 4e-8);
  }
}

TEST(approximate_slerp, N06_sine_ratio_agrees_with_the_sines) {
  for (double a = 0.01; a < 0.785; a += 0.03)
    for (double t = 0; t <= 1; t += 0.05)
      EXPECT_NEAR(sine_ratio(t, std::cos(a) - 1), std::sin(t * a) / std::sin(a), 2e-8);
}

TEST(approximate_slerp, G06_keys_come_back_bit_for_bit) {
  FixedRandom random(3);
  const auto q = random.rotation(), r = -random.rotation();
  EXPECT_EQ(polynomial_slerp(q, r, 0.f), q);
  EXPECT_EQ(polynomial_slerp(q, r, 1.f), r);
  EXPECT_EQ(corrected_nlerp(q, r, 0.f), q);
  EXPECT_EQ(corrected_nlerp(q, r, 1.f), r);
}

}  // namespace
}  // namespace sinew::cost
