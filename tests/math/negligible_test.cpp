// SPDX-License-Identifier: MIT
#include "runtime/math/negligible.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sinew {
namespace {

TEST(negligible, N26_flushes_what_is_below_and_keeps_the_rest_bit_for_bit) {
  for (const float sign : {1.0f, -1.0f}) {
    for (const float tiny : {0.0f, std::numeric_limits<float>::denorm_min(), 1e-30f, 9.99e-21f})
      EXPECT_EQ(flushed(sign * tiny), 0.0f);
    for (const float kept : {kNegligible, 1e-19f, 1.0f, std::numeric_limits<float>::infinity()})
      EXPECT_EQ(flushed(sign * kept), sign * kept);
  }
  EXPECT_FALSE(std::signbit(flushed(-1e-30f)));
  EXPECT_TRUE(std::isnan(flushed(std::numeric_limits<float>::quiet_NaN())));  // NaN is not flushed
}

TEST(negligible, N26_each_component_counts_on_its_own) {
  EXPECT_EQ(flushed(glm::vec3(1e-30f, -2.0f, -1e-41f)), glm::vec3(0.0f, -2.0f, 0.0f));
}

}  // namespace
}  // namespace sinew
