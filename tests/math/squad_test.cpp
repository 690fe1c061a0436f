// SPDX-License-Identifier: MIT
#include "runtime/math/interpolate.h"

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::kEps;
using test::same_rotation;

TEST(squad, N07_held_keys_stay_held) {
  FixedRandom random(1);
  for (int i = 0; i < 50; ++i) {
    const auto q = random.rotation();
    const auto a = squad_control(q, q, q);
    EXPECT_TRUE(same_rotation(a, q, 8 * kEps));
    for (const float t : {0.f, 0.25f, 0.5f, 1.f}) EXPECT_TRUE(same_rotation(squad(q, a, a, q, t), q, 16 * kEps));
  }
}

TEST(squad, N08_keys_with_flipped_signs_give_the_same_curve_after_alignment) {
  FixedRandom random(2);
  Quat<double> keys[4] = {random.rotation<double>()};
  for (int i = 1; i < 4; ++i) keys[i] = keys[i - 1] * random.rotation_by<double>(0.8);
  const auto mid = [](const Quat<double>(&k)[4]) {
    return squad(k[1], squad_control(k[0], k[1], k[2]), squad_control(k[1], k[2], k[3]), k[2], 0.5);
  };
  const auto expected = mid(keys);
  for (int flips = 0; flips < 16; ++flips) {
    Quat<double> k[4];
    for (int i = 0; i < 4; ++i) k[i] = flips & (1 << i) ? -keys[i] : keys[i];
    for (int i = 1; i < 4; ++i) k[i] = aligned_with(k[i - 1], k[i]);
    EXPECT_TRUE(same_rotation(mid(k), expected, 1e-13)) << flips;
  }
}

/// Expects equal angular velocities on both sides of a middle key, in the key's own frame.
void expect_smooth_at_middle_key(double before_s, double after_s, double tolerance) {
  FixedRandom random(3);
  Quat<double> k[4] = {random.rotation<double>()};
  for (int i = 1; i < 4; ++i) k[i] = aligned_with(k[i - 1], k[i - 1] * random.rotation_by<double>(0.6));
  const auto c = squad_controls_uneven(k[0], k[1], k[2], before_s, after_s);
  const double h = 1e-6;
  const auto in = squad(k[0], k[0], c.incoming, k[1], 1 - h), out = squad(k[1], c.outgoing, k[2], k[2], h);
  const auto v_in = -quat_log(quat_conjugate(k[1]) * in) / (h * before_s);
  const auto v_out = quat_log(quat_conjugate(k[1]) * out) / (h * after_s);
  EXPECT_LE(test::distance(v_in, v_out), tolerance) << before_s << " " << after_s;
}

TEST(squad, N09_speed_is_continuous_over_keys_of_uneven_spacing) {
  for (const double after_s : {0.1, 0.5, 1.0, 3.0}) expect_smooth_at_middle_key(1.0, after_s, 1e-4);
}

TEST(squad, N09_the_speed_at_a_key_is_that_of_the_parabola_through_its_neighbours) {
  // A rotation about one axis by t^2 / 2. The three-point rule is exact for parabolas with any spacing.
  const auto at = [](double t) { return quat_xyzw(0.0, std::sin(t * t / 4), 0.0, std::cos(t * t / 4)); };
  for (const auto& [before_s, after_s] : {std::pair{0.5, 0.5}, {0.2, 0.9}, {1.0, 0.125}, {0.7, 0.01}}) {
    const Quat<double> previous = at(1 - before_s), key = at(1), next = at(1 + after_s);
    const auto c = squad_controls_uneven(previous, key, next, before_s, after_s);
    const double h = 1e-6;
    const auto out = squad(key, c.outgoing, next, next, h), in = squad(previous, previous, c.incoming, key, 1 - h);
    EXPECT_NEAR(2 * quat_log(quat_conjugate(key) * out).y / (h * after_s), 1.0, 1e-4) << before_s << " " << after_s;
    EXPECT_NEAR(-2 * quat_log(quat_conjugate(key) * in).y / (h * before_s), 1.0, 1e-4) << before_s << " " << after_s;
  }
}

TEST(squad, N09_even_spacing_gives_the_classic_control_point) {
  FixedRandom random(4);
  Quat<double> k[3] = {random.rotation<double>()};
  for (int i = 1; i < 3; ++i) k[i] = aligned_with(k[i - 1], random.rotation<double>());
  const auto c = squad_controls_uneven(k[0], k[1], k[2], 0.4, 0.4);
  EXPECT_TRUE(same_rotation(c.incoming, squad_control(k[0], k[1], k[2]), 1e-13));
  EXPECT_TRUE(same_rotation(c.outgoing, squad_control(k[0], k[1], k[2]), 1e-13));
}

}  // namespace
}  // namespace sinew
