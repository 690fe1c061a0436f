// SPDX-License-Identifier: MIT
#include "runtime/tiny/tiny.h"

#include <gtest/gtest.h>

#include <cstdlib>

TEST(tiny, clamps) {
  EXPECT_EQ(clamped(-3, 0, 5), 0);
  EXPECT_EQ(clamped(3, 0, 5), 3);
  EXPECT_EQ(clamped(9, 0, 5), 5);
}

TEST(tiny, counts_in_three) {
  for (int value = 0; value <= 4; ++value) EXPECT_EQ(count_in_three(value), value >= 1 && value <= 3);
}

TEST(tiny, distance) {
  EXPECT_EQ(twice_apart(1, 4), 6);
  EXPECT_EQ(twice_apart(4, 1), 6);
}

/// A suite whose setup runs the code before its first test.
class Prepared : public testing::Test {
 protected:
  static void SetUpTestSuite() { value_ = tripled(2); }
  static inline int value_ = 0;
};

/// A test that a mutant causes to be skipped counts as having noticed it.
TEST_F(Prepared, value) {
  if (value_ != 6) GTEST_SKIP();
}

/// This test starts the program again. The record of the earlier tests must survive that.
TEST(started_again, ends_well) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(std::exit(0), testing::ExitedWithCode(0), "");
}
