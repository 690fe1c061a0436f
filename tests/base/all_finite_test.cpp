// SPDX-License-Identifier: MIT
#include "runtime/base/all_finite.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "runtime/math/conventions.h"

namespace sinew {
namespace {

template <class T>
class AllFinite : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(AllFinite, Precisions);

TYPED_TEST(AllFinite, holds_for_every_kind_of_finite_number) {
  using Limits = std::numeric_limits<TypeParam>;
  EXPECT_TRUE(all_finite(std::span<const TypeParam>()));
  const std::vector<TypeParam> numbers{TypeParam(0),     TypeParam(-0.0), TypeParam(1),        Limits::max(),
                                       Limits::lowest(), Limits::min(),   Limits::denorm_min()};
  EXPECT_TRUE(all_finite(numbers));
}

TYPED_TEST(AllFinite, one_odd_number_is_seen_anywhere) {
  using Limits = std::numeric_limits<TypeParam>;
  for (const TypeParam odd : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), -Limits::signaling_NaN()})
    for (std::size_t at = 0; at < 19; ++at) {
      std::vector<TypeParam> numbers(19, TypeParam(1));
      numbers[at] = odd;
      EXPECT_FALSE(all_finite(numbers)) << odd << " at " << at;
    }
}

TEST(AllFiniteVectors, every_component_counts) {
  for (int component = 0; component < 4; ++component) {
    std::vector<glm::quat> keys(3, glm::quat(1, 0, 0, 0));
    EXPECT_TRUE(all_finite(keys));
    keys[2][component] = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(all_finite(keys)) << component;
  }
}

}  // namespace
}  // namespace sinew
