// SPDX-License-Identifier: MIT
// Tests of every fate, on which run_program_test.py tries the runner.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace {

class SharedSetup : public testing::Test {
 protected:
  static void TearDownTestSuite() {
    if (std::getenv("FAIL_OUTSIDE") != nullptr) ADD_FAILURE() << "the suite cannot be torn down";
  }
};
TEST_F(SharedSetup, passes) {}

TEST(fates, passes_with_words_before_its_verdict) { std::fputs("no line ends here", stdout); }
TEST(fates, fails) { EXPECT_EQ(1, 2) << "one is not two"; }
TEST(fates, is_skipped) { GTEST_SKIP() << "no such device"; }
TEST(fates, dies) {
  std::puts("last words");
  std::fflush(stdout);
  std::abort();
}
TEST(fates, leaves_with_success) { std::_Exit(0); }
TEST(fates, hangs) {
  if (std::getenv("HANG") != nullptr) pause();
}
TEST(fates, says_that_another_test_fails) { std::puts("[  FAILED  ] fates.passes_at_last (0 ms)"); }
TEST(fates, passes_at_last) {}
TEST(fates, DISABLED_is_not_listed) { FAIL(); }

class Numbered : public testing::TestWithParam<int> {};
TEST_P(Numbered, is_even) { EXPECT_EQ(GetParam() % 2, 0); }
INSTANTIATE_TEST_SUITE_P(kinds, Numbered, testing::Values(2, 3));

}  // namespace
