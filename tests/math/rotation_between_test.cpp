// SPDX-License-Identifier: MIT
#include "runtime/math/rotation_between.h"

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;
using test::kEps;

TEST(rotation_between, N14_turns_s_into_t_at_every_angle_by_the_shortest_way) {
  FixedRandom random(1);
  for (const double angle : {0.0, 1e-8, 1e-4, 0.1, 1.5, 3.0, 3.14, 3.1415, 3.141592, 3.14159265})
    for (int i = 0; i < 50; ++i) {
      const auto s = random.direction<double>(), side = perpendicular_to(s);
      const auto t = s * std::cos(angle) + side * std::sin(angle);
      const Vec3<float> from(s), to(t);
      const auto q = rotation_between(from, to);
      EXPECT_TRUE(is_near(rotate_vector(q, from), to, 10 * kEps)) << angle;
      EXPECT_NEAR(safe_length(q), 1, 4 * kEps);
      if (angle > 3.1) continue;  // near half a turn, rounding of the inputs decides the angle
      EXPECT_NEAR(test::angle_between(q, quat_identity<float>()), angle, 8 * kEps) << angle;
    }
}

TEST(rotation_between, N14_opposite_vectors_get_a_half_turn) {
  FixedRandom random(2);
  for (int i = 0; i < 100; ++i) {
    const auto s = random.direction();
    const auto q = rotation_between(s, -s);
    EXPECT_TRUE(is_near(rotate_vector(q, s), -s, 8 * kEps));
    EXPECT_NEAR(q.w, 0, 4 * kEps);
  }
}

TEST(rotation_between, N14_vectors_opposite_up_to_a_few_roundings_still_meet) {
  FixedRandom random(3);
  for (int i = 0; i < 20000; ++i) {
    const auto s = random.direction();
    auto t = -s;
    for (int c = 0; c < 3; ++c) t[c] *= 1 + static_cast<float>(random.in(-4, 4) * kEps);
    EXPECT_TRUE(is_near(rotate_vector(rotation_between(s, t), s), t, 12 * kEps)) << i;
  }
}

TEST(rotation_between, lengths_do_not_matter_and_zero_gives_the_identity) {
  const Vec3<float> s(1, 2, 3), t(-2, 1, 0.5f);
  EXPECT_TRUE(test::same_rotation(rotation_between(s * 1e-30f, t * 1e30f), rotation_between(s, t), 8 * kEps));
  EXPECT_EQ(rotation_between(Vec3<float>(0), t), quat_identity<float>());
  EXPECT_EQ(rotation_between(s, s), quat_identity<float>());
}

}  // namespace
}  // namespace sinew
