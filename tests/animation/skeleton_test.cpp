// SPDX-License-Identifier: MIT
#include "runtime/animation/skeleton.h"

#include <gtest/gtest.h>

#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

TEST(skeleton, G53_names_may_repeat_or_be_missing_and_the_first_is_found) {
  Skeleton s = test::chain_skeleton(4);
  s.names = {"hip", "", "arm", "arm"};
  EXPECT_EQ(s.find("arm"), 2u);
  EXPECT_EQ(s.find(""), 1u);
  EXPECT_EQ(s.find("leg"), std::nullopt);
  EXPECT_EQ(Skeleton{}.find("arm"), std::nullopt);
}

}  // namespace
}  // namespace sinew
