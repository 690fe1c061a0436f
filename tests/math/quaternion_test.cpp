// SPDX-License-Identifier: MIT
#include "runtime/math/quaternion.h"

#include <limits>

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;
using test::kEps;
using test::same_rotation;

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(quaternion, normalised_without_direction_is_the_identity) {
  for (const auto& q : {quat_xyzw(0.f, 0.f, 0.f, 0.f), quat_xyzw(kNan, 0.f, 0.f, 1.f), quat_xyzw(0.f, 0.f, 0.f, kNan),
                        quat_xyzw(0.f, kInf, 0.f, 1.f)})
    EXPECT_EQ(normalised(q), quat_identity<float>());
}

TEST(quaternion, normalised_works_at_lengths_whose_squares_overflow_or_vanish) {
  FixedRandom random(1);
  for (const float length : {1e-44f, 1e-30f, 1e-10f, 1.f, 1e10f, 1e38f}) {
    const Quat<float> q = random.rotation();
    if (length < 1e-40f)
      EXPECT_EQ(normalised(quat_xyzw(0.f, length, 0.f, 0.f)), quat_xyzw(0.f, 1.f, 0.f, 0.f));
    else
      EXPECT_TRUE(same_rotation(normalised(q * length), q, 4 * kEps)) << length;
  }
}

TEST(quaternion, inverse_times_itself_is_the_identity_at_any_length) {
  FixedRandom random(2);
  for (const double length : {1e-15, 0.1, 1.0, 7.0, 1e15}) {
    const Quat<double> q = random.rotation<double>() * length;
    EXPECT_TRUE(same_rotation(q * quat_inverse(q), quat_identity<double>(), 1e-14)) << length;
  }
  EXPECT_EQ(quat_inverse(quat_xyzw(0.f, 0.f, 0.f, 0.f)), quat_identity<float>());
}

TEST(quaternion, product_applies_the_right_factor_first) {
  const float h = std::sqrt(0.5f);
  const auto about_x = quat_xyzw(h, 0.f, 0.f, h), about_z = quat_xyzw(0.f, 0.f, h, h);
  EXPECT_TRUE(is_near(rotate_vector(about_z * about_x, Vec3<float>(0, 1, 0)), Vec3<float>(0, 0, 1), 4 * kEps));
  EXPECT_TRUE(is_near(rotate_vector(about_x * about_z, Vec3<float>(0, 1, 0)), Vec3<float>(-1, 0, 0), 4 * kEps));
}

TEST(quaternion, rotate_vector_agrees_with_the_sandwich_product) {
  FixedRandom random(3);
  for (int i = 0; i < 200; ++i) {
    const auto q = random.rotation<double>();
    const auto p = random.vec3<double>();
    const auto r = q * quat_xyzw(p.x, p.y, p.z, 0.0) * quat_conjugate(q);
    EXPECT_TRUE(is_near(rotate_vector(q, p), Vec3<double>(r.x, r.y, r.z), 1e-14));
  }
}

TEST(quaternion, aligned_with_counts_a_dot_of_zero_as_positive) {
  const auto q = quat_xyzw(1.f, 0.f, 0.f, 0.f), r = quat_xyzw(0.f, 1.f, 0.f, 0.f);
  EXPECT_EQ(aligned_with(q, r), r);
  EXPECT_EQ(aligned_with(q, -r), -r);
  EXPECT_EQ(aligned_with(q, -q), q);
}

TEST(quaternion, N03_rotation_angle_resolves_what_acos_of_the_dot_cannot) {
  FixedRandom random(4);
  for (const double angle : {1e-7, 1e-5, 1e-4, 3e-4, 1e-2}) {
    const auto q = random.rotation<double>();
    const auto r = q * random.rotation_by<double>(angle);
    EXPECT_NEAR(rotation_angle_between(q, r) / angle, 1.0, 1e-8) << angle;
    EXPECT_NEAR(rotation_angle_between(q, -r) / angle, 1.0, 1e-8) << angle;
  }
  const auto tiny = quat_xyzw(1e-5f, 0.f, 0.f, 1.f);
  EXPECT_FLOAT_EQ(rotation_angle_between(quat_identity<float>(), tiny), 2e-5f);
  EXPECT_EQ(2 * std::acos(std::min(1.f, quat_dot(quat_identity<float>(), tiny))), 0.f);
}

}  // namespace
}  // namespace sinew
