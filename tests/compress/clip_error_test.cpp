// SPDX-License-Identifier: MIT
#include "runtime/compress/clip_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

Animation of_keys(Interpolation interpolation, std::vector<float> times_s) {
  test::FixedRandom random(1);
  BoneAnimation bone;
  bone.translation = test::random_vectors(random, interpolation, times_s);
  return test::animation_of({bone});
}

bool has(const std::vector<double>& times, float time_s) {
  return std::count(times.begin(), times.end(), static_cast<double>(time_s)) == 1;
}

TEST(clip_error, G13_times_right_before_jumps_are_looked_at) {
  const auto steps = times_to_check(of_keys(Interpolation::step, {0.0f, 0.5f, 1.0f}), 1);
  const auto lines = times_to_check(of_keys(Interpolation::linear, {0.0f, 0.5f, 0.5f, 1.0f}), 1);
  for (const float key : {0.5f, 1.0f}) EXPECT_TRUE(has(steps, std::nextafter(key, -1.0f))) << key;
  EXPECT_TRUE(has(lines, std::nextafter(0.5f, -1.0f)));
  EXPECT_FALSE(has(lines, std::nextafter(1.0f, -1.0f))) << "there is no jump";
  for (const auto& times : {steps, lines}) {
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    for (const float time_s : {0.0f, 0.5f, 1.0f}) EXPECT_TRUE(has(times, time_s));
  }
  EXPECT_EQ(lines.size(), 3 + 10 + 1u);
}

TEST(clip_error, large_clips_are_looked_at_on_keys_and_between_them) {
  std::vector<float> keys_s;
  for (int k = 0; k <= 10'000; ++k) keys_s.push_back(static_cast<float>(k));
  const Animation animation = of_keys(Interpolation::linear, std::move(keys_s));
  const std::vector<double> all = times_to_check(animation, 0);
  EXPECT_EQ(all.size(), 60'001u);
  EXPECT_EQ(times_to_check(animation, kMaxJointTimes / all.size()), all) << "as many as may be";
  for (const std::size_t joints : {167u, 300u, 900u, 1900u}) {
    const auto times = times_to_check(animation, joints);
    const auto step = static_cast<std::size_t>(std::lround(6.0 * times[1]));
    EXPECT_GE(step, all.size() * joints / kMaxJointTimes + 1);
    ASSERT_EQ(times.size(), (all.size() + step - 1) / step) << joints;
    for (std::size_t i = 0; i < times.size(); ++i) ASSERT_EQ(times[i], all[i * step]) << joints;
    EXPECT_LE(times.size() * joints, kMaxJointTimes + joints);
    int phases[6] = {};
    for (const double time_s : times) ++phases[std::lround((time_s - std::floor(time_s)) * 6.0) % 6];
    for (const int count : phases) EXPECT_GT(6 * count, static_cast<int>(times.size()) / 2) << joints << " joints";
  }
}

TEST(clip_error, a_list_that_is_a_whole_number_of_steps_ends_with_its_last_step) {
  std::vector<float> keys_s;
  for (int k = 0; k <= 10'004; ++k) keys_s.push_back(static_cast<float>(k));
  const auto times = times_to_check(of_keys(Interpolation::linear, std::move(keys_s)), 1000);  // 60,025 = 7 * 8575
  ASSERT_EQ(times.size(), 8575u);
  EXPECT_NEAR(times[1], 7.0 / 6.0, 1e-9);
  EXPECT_NEAR(times.back(), 7.0 * 8574.0 / 6.0, 1e-6);
}

}  // namespace
}  // namespace sinew
