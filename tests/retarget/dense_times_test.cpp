// SPDX-License-Identifier: MIT
#include "runtime/retarget/dense_times.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sinew {
namespace {

using testing::ElementsAre;

TEST(dense_times, are_those_of_all_keys_and_of_both_ends_once) {
  Animation animation{"", 0.03125, {}, {}};
  animation.bones.resize(2);
  animation.bones[0].rotation.times_s = {0.0f, 0.015625f};
  animation.bones[0].translation.times_s = {0.0078125f, 0.015625f};
  animation.bones[1].scale.times_s = {0.0234375f};
  EXPECT_THAT(dense_times(animation), ElementsAre(0.0, 0.0078125, 0.015625, 0.0234375, 0.03125));
}

TEST(dense_times, between_keys_are_at_most_a_60th_of_a_second_apart_in_equal_parts) {
  Animation animation{"", 1.0, {}, {}};
  animation.bones.emplace_back().rotation.times_s = {0.0f, 0.25f};
  const std::vector<double> times = dense_times(animation);
  ASSERT_EQ(times.size(), 61u) << "keys lie on the grid";
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], static_cast<double>(i) / 60.0, 1e-12);
  animation.bones[0].rotation.times_s[1] = 0.02f;
  EXPECT_NEAR(dense_times(animation)[1], 0.01, 1e-9) << "a gap of more than a 60th has two parts";
}

TEST(dense_times, of_an_animation_without_length_are_one) {
  EXPECT_THAT(dense_times({"", 0.0, {}, {}}), ElementsAre(0.0));
}

}  // namespace
}  // namespace sinew
