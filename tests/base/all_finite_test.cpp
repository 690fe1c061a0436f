// SPDX-License-Identifier: MIT
#include "runtime/base/all_finite.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace sinew {
namespace {

using Limits = std::numeric_limits<float>;

TEST(all_finite, holds_for_every_kind_of_finite_number) {
  EXPECT_TRUE(all_finite(std::span<const float>()));
  const std::vector<float> numbers{
      0.0f, -0.0f, 1.0f, Limits::max(), Limits::lowest(), Limits::min(), Limits::denorm_min()};
  EXPECT_TRUE(all_finite(std::span<const float>(numbers)));
}

TEST(all_finite, one_odd_number_is_seen_anywhere) {
  for (const float odd : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), -Limits::signaling_NaN()})
    for (std::size_t at = 0; at < 19; ++at) {
      std::vector<float> numbers(19, 1.0f);
      numbers[at] = odd;
      EXPECT_FALSE(all_finite(std::span<const float>(numbers))) << odd << " at " << at;
    }
}

}  // namespace
}  // namespace sinew
