// SPDX-License-Identifier: MIT
#include "runtime/clip/clip_rest.h"

#include <gtest/gtest.h>

#include "runtime/base/same_bits.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using Own = BaseNumbers::Own;

std::vector<float> copy_of(const BaseNumbers& numbers) {
  std::vector<float> out(numbers.size(), -7.0f);
  numbers.copy_to(out.data());
  return out;
}

std::vector<float> rising(std::size_t count) {
  std::vector<float> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<float>(i);
  return numbers;
}

TEST(base_numbers, none_are_empty) {
  EXPECT_EQ(BaseNumbers().size(), 0u);
  EXPECT_EQ(BaseNumbers().byte_size(), 0u);
  EXPECT_TRUE(copy_of(BaseNumbers()).empty());
  EXPECT_TRUE(copy_of(BaseNumbers(rest_numbers({}))).empty());
}

TEST(base_numbers, a_few_of_their_own_lie_over_those_that_are_shared) {
  const RestNumbers rest = rest_numbers(rising(100));
  const BaseNumbers numbers(rest, {{90, 5.0f}, {3, -1.0f}, {90, 6.0f}});
  std::vector<float> expected = rising(100);
  expected[3] = -1.0f;
  expected[90] = 6.0f;  // of two values the last one counts
  EXPECT_EQ(copy_of(numbers), expected);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(numbers[i], expected[i]);
  EXPECT_EQ(numbers.rest(), rest);
  EXPECT_EQ(numbers.byte_size(), 2 * sizeof(Own));
}

TEST(base_numbers, what_is_as_at_rest_takes_nothing) {
  const BaseNumbers numbers(rest_numbers(rising(10)), {{4, 4.0f}, {0, 1.0f}, {0, 0.0f}});
  EXPECT_TRUE(numbers.own().empty());
  EXPECT_EQ(copy_of(numbers), rising(10));
}

TEST(base_numbers, zeros_of_other_sign_differ) {
  const BaseNumbers numbers(rest_numbers(rising(20)), {{0, -0.0f}});
  ASSERT_EQ(numbers.own().size(), 1u);
  EXPECT_TRUE(std::signbit(copy_of(numbers)[0]));
}

TEST(base_numbers, many_of_their_own_are_a_copy) {
  const RestNumbers rest = rest_numbers(rising(64));
  for (const std::uint32_t count : {4u, 5u}) {
    std::vector<Own> own;
    std::vector<float> expected = rising(64);
    for (std::uint32_t i = 0; i < count; ++i) own.push_back({i * 9, expected[i * 9] = 1000.0f});
    const BaseNumbers numbers(rest, own);
    EXPECT_EQ(numbers.rest() == rest, count == 4) << count;
    EXPECT_EQ(numbers.byte_size(), count == 4 ? 4 * sizeof(Own) : 64 * sizeof(float)) << count;
    EXPECT_EQ(copy_of(numbers), expected) << count;
    EXPECT_EQ(numbers[9], 1000.0f) << count;
  }
}

TEST(base_numbers, numbers_over_others_have_the_same_bits) {
  test::FixedRandom random(5);
  const RestNumbers rest = rest_numbers(rising(1000));
  for (const std::uint32_t changes : {0u, 1u, 60u, 900u}) {
    std::vector<float> numbers = rising(1000);
    for (std::uint32_t i = 0; i < changes; ++i) numbers[random.below(1000)] = random.vec3().x;
    const BaseNumbers base = BaseNumbers::over(rest, numbers);
    const std::vector<float> copy = copy_of(base);
    EXPECT_TRUE(same_bits<float>(copy, numbers)) << changes;
    EXPECT_EQ(base.rest() == rest, changes <= 60) << changes;
  }
}

TEST(base_numbers, copies_outlive_what_they_were_copied_from) {
  BaseNumbers copy;
  {
    const BaseNumbers numbers(rest_numbers(rising(8)), {{1, 9.0f}});
    copy = numbers;
  }
  std::vector<float> expected = rising(8);
  expected[1] = 9.0f;
  EXPECT_EQ(copy_of(copy), expected);
}

}  // namespace
}  // namespace sinew
