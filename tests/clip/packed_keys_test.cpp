// SPDX-License-Identifier: MIT
#include "runtime/clip/packed_keys.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

QuatTrack wandering(test::FixedRandom& random, std::size_t keys, double step_rad) {
  QuatTrack track{Interpolation::linear, {}, {}};
  Quat<double> q = random.rotation<double>();
  for (std::size_t k = 0; k < keys; ++k) {
    q = normalised(q * random.rotation_by<double>(random.in(0, step_rad)));
    track.times_s.push_back(static_cast<float>(k));
    track.values.push_back(quat_cast<float>(k % 3 == 0 ? -q : q));  // the sign of a quaternion has no meaning
  }
  return track;
}

TEST(packed_keys, rotations_are_within_the_tolerance_and_coarser_ones_take_fewer_bits) {
  test::FixedRandom random(1);
  for (int round = 0; round < 30; ++round) {
    const QuatTrack track = wandering(random, 40, round % 2 ? 0.05 : 2.0);
    std::uint32_t before = 1000;
    for (const double part : {1e-3, 1e-2, 1e-1}) {
      const double tolerance = round % 2 ? 0.1 * part : part;
      const auto packed = pack_keys(track, tolerance);
      ASSERT_TRUE(packed);
      EXPECT_LE(packed->bits_per_key(), before);
      before = packed->bits_per_key();
      for (std::size_t k = 0; k < track.key_count(); ++k) {
        const auto v = unpack_key(*packed, k);
        EXPECT_LE(2 * std::sin(test::angle_between(quat_xyzw(v[0], v[1], v[2], v[3]), track.values[k]) / 2),
                  tolerance * (1 + 1e-6));
      }
    }
  }
}

TEST(packed_keys, rotations_near_each_other_leave_one_component_out) {
  test::FixedRandom random(2);
  const auto packed = pack_keys(wandering(random, 20, 0.02), 1e-4);
  ASSERT_TRUE(packed);
  EXPECT_LT(packed->derived, PackedTrack::kNoneDerived);
  EXPECT_EQ(packed->width[packed->derived], 0);
}

TEST(packed_keys, components_that_do_not_change_take_no_bits_and_keep_their_value) {
  const Vec3Track track{Interpolation::linear, {0, 1, 2}, {{0.1f, 0, 7}, {0.1f, 1, 7}, {0.1f, 0.5f, 7}}};
  const auto packed = pack_keys(track, 1e-3);
  ASSERT_TRUE(packed);
  EXPECT_EQ(packed->width[0], 0);
  EXPECT_EQ(packed->width[2], 0);
  EXPECT_GT(packed->width[1], 0);
  EXPECT_EQ(unpack_key(*packed, 1)[0], 0.1f);
  EXPECT_EQ(unpack_key(*packed, 2)[2], 7.0f);
}

TEST(packed_keys, what_takes_too_many_bits_or_is_a_curve_is_not_packed) {
  EXPECT_FALSE(pack_keys(Vec3Track{Interpolation::linear, {0, 1}, {{0, 0, 0}, {1, 1, 1}}}, 1e-9));
  EXPECT_FALSE(pack_keys(Vec3Track{Interpolation::linear, {0, 1}, {{0, 0, 0}, {1, 1, 1}}}, 0.0));
  EXPECT_FALSE(pack_keys(Vec3Track{Interpolation::cubic_spline, {0}, {{0, 0, 0}, {1, 1, 1}, {0, 0, 0}}}, 1.0));
  test::FixedRandom random(3);
  EXPECT_FALSE(pack_keys(wandering(random, 10, 1.0), 1e-8));
}

TEST(packed_keys, rotations_come_back_whichever_component_is_left_out_and_whatever_its_sign) {
  for (std::uint32_t largest = 0; largest < 4; ++largest)
    for (const float sign : {-1.0f, 1.0f}) {
      test::FixedRandom random(10 + largest);
      QuatTrack track{Interpolation::linear, {}, {}};
      for (int k = 0; k < 12; ++k) {
        float numbers[4];
        for (float& number : numbers) number = static_cast<float>(random.in(-0.2, 0.2));
        numbers[largest] = sign;
        track.times_s.push_back(static_cast<float>(k));
        track.values.push_back(normalised(quat_xyzw(numbers[0], numbers[1], numbers[2], numbers[3])));
      }
      const auto packed = pack_keys(track, 1e-3);
      ASSERT_TRUE(packed);
      EXPECT_EQ(packed->derived, largest);
      for (std::size_t k = 0; k < track.key_count(); ++k) {
        const auto v = unpack_key(*packed, k);
        EXPECT_NEAR(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3], 1.0f, 1e-6f);
        EXPECT_LE(test::angle_between(quat_xyzw(v[0], v[1], v[2], v[3]), track.values[k]), 1.001e-3)
            << "component " << largest;
      }
    }
}

}  // namespace
}  // namespace sinew
