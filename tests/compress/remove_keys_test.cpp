// SPDX-License-Identifier: MIT
#include "runtime/compress/remove_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "runtime/animation/track_sample.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using testing::ElementsAre;

std::vector<float> evenly(std::size_t count) {
  std::vector<float> times(count);
  std::iota(times.begin(), times.end(), 0.0f);
  return times;
}

std::vector<std::uint32_t> needed(Vec3Track track, double tolerance) {
  const LooseTrack loose{&track, tolerance};
  return keys_needed({&loose, 1}, track.key_count());
}

TEST(remove_keys, keys_on_a_line_are_left_out_and_corners_stay) {
  EXPECT_THAT(needed({Interpolation::linear, evenly(5), {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 0, 0}}}, 1e-6),
              ElementsAre(0, 2, 4));
  EXPECT_THAT(needed({Interpolation::linear, {0, 1, 3, 4}, {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {9, 0, 0}}}, 1e-6),
              ElementsAre(0, 2, 3));
}

TEST(remove_keys, G07_steps_keep_each_key_that_changes_the_value) {
  EXPECT_THAT(
      needed({Interpolation::step, evenly(6), {{0, 0, 0}, {0, 0, 0}, {5, 0, 0}, {5, 0, 0}, {5, 0, 0}, {0, 0, 0}}},
             1e-6),
      ElementsAre(0, 2, 5));
}

TEST(remove_keys, G13_both_sides_of_a_jump_stay) {
  EXPECT_THAT(needed({Interpolation::linear, {0, 1, 2, 2, 3, 4}, std::vector<glm::vec3>(6, glm::vec3(1))}, 1.0),
              ElementsAre(0, 2, 3, 5));
}

TEST(remove_keys, G03_a_cubic_through_samples_of_one_cubic_keeps_its_ends_only) {
  Vec3Track track{Interpolation::cubic_spline, evenly(9), {}};
  for (const float t : track.times_s) {
    const glm::vec3 slope(3 * t * t - 4 * t, 1, 2 * t), value(t * t * t - 2 * t * t, t, t * t);
    track.values.insert(track.values.end(), {slope, value, slope});
  }
  EXPECT_THAT(needed(track, 1e-3), ElementsAre(0, 8));
  const LooseTrack loose{&track, 1e-3};
  keep_keys(loose, std::vector<std::uint32_t>{0, 8});
  EXPECT_EQ(track.values.size(), 6u);
  for (double t = 0.1; t < 8; t += 0.1) EXPECT_NEAR(sample_track<double>(track, t).x, t * t * t - 2 * t * t, 1e-4);
}

TEST(remove_keys, tracks_that_share_times_keep_what_any_of_them_needs) {
  Vec3Track a{Interpolation::linear, evenly(5), {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 0, 0}}};
  Vec3Track b{Interpolation::linear, evenly(5), {{0, 0, 0}, {9, 0, 0}, {9, 0, 0}, {9, 0, 0}, {9, 0, 0}}};
  const std::vector<LooseTrack> both{{&a, 1e-6}, {&b, 1e-6}};
  EXPECT_THAT(keys_needed(both, 5), ElementsAre(0, 1, 2, 4));
}

TEST(remove_keys, what_is_left_stays_within_the_tolerance_of_random_tracks) {
  test::FixedRandom random(2);
  for (int round = 0; round < 60; ++round) {
    const Interpolation kinds[] = {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline};
    const Interpolation kind = kinds[round % 3];
    const auto times = test::random_times(random, 2 + random.below(80), random.below(3));
    QuatTrack track{kind, times, {}};
    Quat<double> q = random.rotation<double>();
    for (std::size_t i = 0; i < test::value_count(kind, times.size()); ++i) {
      q = q * random.rotation_by<double>(random.in(0, 0.2));
      const bool tangent = kind == Interpolation::cubic_spline && i % 3 != 1;
      track.values.push_back(tangent ? quat_cast<float>(random.rotation<double>() * 0.1) : quat_cast<float>(q));
    }
    const QuatTrack before = track;
    const double tolerance = random.in(0.01, 0.5);
    const LooseTrack loose{&track, tolerance};
    keep_keys(loose, keys_needed({&loose, 1}, times.size()));
    EXPECT_LT(track.key_count(), before.key_count() + 1);
    for (const float t : times)
      EXPECT_LE(2 * std::sin(test::angle_between(sample_track<double>(before, double(t)),
                                                 sample_track<double>(track, double(t))) /
                             2),
                tolerance + 1e-6)
          << round;
  }
}

TEST(remove_keys, hold_still_takes_the_middle_and_respects_the_tolerance) {
  Vec3Track track{Interpolation::linear, {1, 2, 4}, {{0, 0, 0}, {0.02f, 0, 0}, {0.01f, 0, 0}}};
  EXPECT_FALSE(flatten_to_constant(LooseTrack{&track, 0.009}));
  EXPECT_EQ(track.key_count(), 3u);
  EXPECT_TRUE(flatten_to_constant(LooseTrack{&track, 0.011}));
  EXPECT_EQ(track.times_s, (std::vector<float>{1, 4}));
  EXPECT_FLOAT_EQ(track.values[0].x, 0.01f);
  EXPECT_EQ(track.values[0], track.values[1]);
}

TEST(remove_keys, hold_still_sees_what_cubic_curves_do_between_equal_keys) {
  const glm::vec3 none(0), fast(0, 4, 0);
  Vec3Track track{Interpolation::cubic_spline, {0, 1}, {none, none, fast, fast, none, none}};
  EXPECT_FALSE(flatten_to_constant(LooseTrack{&track, 0.1}));
}

TEST(remove_keys, weights_count_by_what_they_displace) {
  const std::vector<float> metres{1.0f, 0.001f};
  WeightTrack track{Interpolation::linear, {0, 1, 2}, {0, 0, 1, 1, 2, 0}, 2};
  const LooseTrack loose{&track, 0.002, metres};
  EXPECT_THAT(keys_needed({&loose, 1}, 3), ElementsAre(0, 2));
  const LooseTrack strict{&track, 0.0005, metres};
  EXPECT_THAT(keys_needed({&strict, 1}, 3), ElementsAre(0, 1, 2));
  keep_keys(loose, std::vector<std::uint32_t>{0, 2});
  EXPECT_EQ(track.values, (std::vector<float>{0, 0, 2, 0}));
}

/// Makes each key in turn the one that is farthest from the others.
template <class TrackType, class Set>
void expect_each_key_to_count(const Set& set) {
  for (std::size_t odd = 0; odd < 4; ++odd) {
    TrackType track = set(odd);
    EXPECT_FALSE(flatten_to_constant(LooseTrack{&track, 0.49, std::vector<float>{1.0f, 1.0f}})) << odd;
    EXPECT_EQ(track.key_count(), 4u);
    EXPECT_TRUE(flatten_to_constant(LooseTrack{&track, 0.51, std::vector<float>{1.0f, 1.0f}})) << odd;
    EXPECT_EQ(track.key_count(), 2u);
  }
}

TEST(remove_keys, hold_still_looks_at_every_key) {
  expect_each_key_to_count<Vec3Track>([](std::size_t odd) {
    Vec3Track track{Interpolation::linear, evenly(4), std::vector<glm::vec3>(4, glm::vec3(1))};
    track.values[odd].z = odd % 2 == 0 ? 2.0f : 0.0f;
    return track;
  });
  expect_each_key_to_count<WeightTrack>([](std::size_t odd) {
    WeightTrack track{Interpolation::linear, evenly(4), std::vector<float>(8, 1.0f), 2};
    track.values[2 * odd + 1] = odd % 2 == 0 ? 2.0f : 0.0f;
    return track;
  });
}

TEST(remove_keys, hold_still_turns_to_the_mean_of_all_rotations_on_one_side) {
  // Three keys at 0 and one at +-0.04 rad: the mean is near 0.01 and the farthest key is 0.03 away.
  for (std::size_t odd = 0; odd < 4; ++odd)
    for (const float sign : {1.0f, -1.0f}) {
      QuatTrack track{Interpolation::linear, evenly(4), std::vector<glm::quat>(4, quat_identity<float>())};
      track.values[odd] = quat_xyzw(0.02f, 0.0f, 0.0f, std::sqrt(1.0f - 0.0004f)) * sign;
      EXPECT_FALSE(flatten_to_constant(LooseTrack{&track, 0.0299})) << odd;
      ASSERT_TRUE(flatten_to_constant(LooseTrack{&track, 0.0301})) << odd;
      EXPECT_NEAR(std::abs(track.values[0].x), 0.005f, 1e-5f);
      EXPECT_NEAR(std::abs(track.values[0].w), 1.0f, 1e-4f);
    }
}

TEST(remove_keys, hold_still_gives_each_weight_its_own_middle) {
  const std::vector<float> metres{1.0f, 1.0f, 1.0f};
  WeightTrack track{Interpolation::linear, {1, 2, 4}, {0.0f, 5.0f, -1.0f, 0.2f, 5.0f, -1.4f, 0.1f, 5.1f, -1.2f}, 3};
  EXPECT_FALSE(flatten_to_constant(LooseTrack{&track, 0.3, metres}));
  ASSERT_TRUE(flatten_to_constant(LooseTrack{&track, 0.36, metres})) << "0.1 + 0.05 + 0.2";
  EXPECT_EQ(track.times_s, (std::vector<float>{1, 4}));
  EXPECT_EQ(track.interpolation, Interpolation::step);
  EXPECT_EQ(track.target_count, 3u);
  ASSERT_EQ(track.values.size(), 6u);
  const float middle[] = {0.1f, 5.05f, -1.2f};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(track.values[i], middle[i % 3], 1e-6f) << i;
}

TEST(remove_keys, weights_that_overshoot_between_equal_keys_do_not_hold_still) {
  const std::vector<float> metres{1.0f, 1.0f};
  // Rows of in-tangents, values and out-tangents. The second weight leaves its key at 4 per second and rises to 4 *
  // 4/27.
  WeightTrack track{Interpolation::cubic_spline, {0, 1}, {0, 0, 1, 1, 0, 4, 0, 0, 1, 1, 0, 0}, 2};
  EXPECT_FALSE(flatten_to_constant(LooseTrack{&track, 0.5, metres}));
  EXPECT_TRUE(flatten_to_constant(LooseTrack{&track, 0.6, metres}));
}

TEST(remove_keys, cubic_curves_are_compared_between_keys_too) {
  // All keys are 0, on the line between the ends. Only the curves between them leave it, by 4/27 of a tangent.
  Vec3Track track{Interpolation::cubic_spline, evenly(5), std::vector<glm::vec3>(15)};
  track.values[3 * 2 + 2].y = 1.0f;  // out-tangent of the third key
  EXPECT_THAT(needed(track, 0.1), ElementsAre(0, 2, 3, 4)) << "the curve stays";
  EXPECT_THAT(needed(track, 0.15), ElementsAre(0, 4));
  const std::vector<float> metres{1.0f};
  WeightTrack weights{Interpolation::cubic_spline, evenly(5), std::vector<float>(15), 1};
  weights.values[3 * 2 + 2] = 1.0f;
  const LooseTrack strict{&weights, 0.1, metres}, loose{&weights, 0.15, metres};
  EXPECT_THAT(keys_needed({&strict, 1}, 5), ElementsAre(0, 2, 3, 4));
  EXPECT_THAT(keys_needed({&loose, 1}, 5), ElementsAre(0, 4));
}

TEST(remove_keys, rotations_are_compared_along_the_arc) {
  // 0, 0.2 and 0.4 rad are on one slerp at even times. At times 0, 1/4 and 1 the middle key is off by 0.1 rad.
  const auto turned = [](double angle) {
    return quat_xyzw(0.0f, static_cast<float>(std::sin(angle / 2)), 0.0f, static_cast<float>(std::cos(angle / 2)));
  };
  const auto keys = [&](std::vector<float> times, double tolerance) {
    QuatTrack track{Interpolation::linear, std::move(times), {turned(0.0), turned(0.2) * -1.0f, turned(0.4)}};
    const LooseTrack loose{&track, tolerance};
    return keys_needed({&loose, 1}, 3);
  };
  EXPECT_THAT(keys({0, 1, 2}, 1e-6), ElementsAre(0, 2));
  EXPECT_THAT(keys({0, 1, 4}, 0.1001), ElementsAre(0, 2));
  EXPECT_THAT(keys({0, 1, 4}, 0.0998), ElementsAre(0, 1, 2));
}

TEST(remove_keys, a_step_takes_at_most_the_longest_number_of_keys) {
  Vec3Track track{Interpolation::linear, evenly(2 * kLongestStep + 2), {}};
  for (const float t : track.times_s) track.values.push_back(glm::vec3(t));
  EXPECT_THAT(needed(track, 1e-3), ElementsAre(0, kLongestStep, 2 * kLongestStep, 2 * kLongestStep + 1));
}

TEST(remove_keys, only_the_first_keys_are_looked_at_for_an_estimate) {
  Vec3Track track{Interpolation::linear, evenly(6), {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {9, 0, 0}, {0, 0, 0}, {5, 0, 0}}};
  const LooseTrack loose{&track, 1e-6};
  EXPECT_THAT(keys_needed({&loose, 1}, 3), ElementsAre(0, 2));
  EXPECT_THAT(keys_needed({&loose, 1}, 1), ElementsAre(0));
}

TEST(remove_keys, remembered_deviations_change_no_key) {
  test::FixedRandom random(21);
  for (const Interpolation kind : {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline})
    for (const std::size_t most_steps : {0u, 40u, 100'000u}) {
      QuatTrack track = test::random_rotations(random, kind, evenly(90));
      for (std::size_t i = 1; i < track.values.size(); ++i)
        track.values[i] = normalised(track.values[i - 1] + track.values[i] * 0.02f);
      StepDeviations known(most_steps);
      for (const double tolerance : {0.05, 0.4, 0.0, 0.1, 3.0, 0.02, 0.4}) {
        const LooseTrack plain{&track, tolerance}, remembering{&track, tolerance, {}, &known};
        EXPECT_EQ(keys_needed({&remembering, 1}, 90), keys_needed({&plain, 1}, 90)) << tolerance << " " << most_steps;
      }
    }
}

}  // namespace
}  // namespace sinew
