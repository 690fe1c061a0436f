// SPDX-License-Identifier: MIT
#include "runtime/clip/key_times.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

void expect_same_as_plain_search(const std::vector<float>& times, double t) {
  const KeyPosition found = KeyTimes(times).locate(t), expected = locate_key(times, t);
  EXPECT_EQ(found.key, expected.key) << "at " << t;
  EXPECT_EQ(found.on_key, expected.on_key) << "at " << t;
  EXPECT_EQ(found.fraction, expected.fraction) << "at " << t;
  EXPECT_EQ(found.interval_s, expected.interval_s) << "at " << t;
}

std::vector<float> spread(int kind, test::FixedRandom& random) {
  switch (kind) {
    case 0: return test::random_times(random, 50, 5);
    case 1: return {1.5f};
    case 2: return {2, 2, 2};
    case 3: return {0, std::numeric_limits<float>::denorm_min()};
    case 4: return {0, 1e-6f, 2e-6f, 3e-6f, 4e-6f, 36000};
    case 5: return {0, 0, 1, 1};
    default: {
      std::vector<float> even;
      for (int i = 0; i < 500; ++i) even.push_back(static_cast<float>(i) / 30.0f);
      return even;
    }
  }
}

TEST(key_times, bucketed_search_answers_as_the_plain_one_on_beside_and_between_keys) {
  test::FixedRandom random(3);
  for (int kind = 0; kind <= 6; ++kind) {
    const auto times = spread(kind, random);
    std::vector<double> asked{-1, 0, 1e12, std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
    for (const float t : times)
      for (const double x : {double(t), std::nextafter(double(t), -1.0), std::nextafter(double(t), 1e9)})
        asked.push_back(x);
    for (int i = 0; i < 200; ++i) asked.push_back(random.in(double(times.front()), double(times.back())));
    for (const double t : asked) expect_same_as_plain_search(times, t);
  }
}

/// Keys at `fps`, each moved by up to a third of the interval.
std::vector<float> nearly_even(std::size_t count, double fps, test::FixedRandom& random) {
  std::vector<float> times;
  for (std::size_t i = 0; i < count; ++i)
    times.push_back(static_cast<float>((static_cast<double>(i) + random.in(0.0, 1.0 / 3.0)) / fps));
  return times;
}

TEST(key_times, P03_a_search_takes_the_same_few_comparisons_however_many_keys_there_are) {
  test::FixedRandom random(5);
  for (const std::size_t count : {std::size_t{2}, std::size_t{10}, std::size_t{1'000}, std::size_t{100'000}})
    for (const double fps : {24.0, 30.0, 1000.0})
      EXPECT_LE(KeyTimes(nearly_even(count, fps, random)).search_steps(), 2u) << count << " keys at " << fps;
  EXPECT_EQ(KeyTimes(std::vector<float>{1.5f}).search_steps(), 1u);
}

TEST(key_times, P03_crowded_keys_take_no_more_comparisons_than_a_binary_search) {
  for (const std::size_t count : {std::size_t{100}, std::size_t{10'000}}) {
    std::vector<float> times;  // all within one second, except one an hour later
    for (std::size_t i = 0; i + 1 < count; ++i) times.push_back(static_cast<float>(i) / static_cast<float>(count));
    times.push_back(3600.0f);
    const KeyTimes keys(times);
    EXPECT_GE(keys.search_steps(), static_cast<std::size_t>(std::bit_width(count / 50))) << "they share few buckets";
    EXPECT_LE(keys.search_steps(), static_cast<std::size_t>(std::bit_width(count)));
  }
}

TEST(key_times, a_time_that_is_not_a_number_falls_on_the_first_key) {
  const KeyTimes times(std::vector<float>{1, 2, 3});
  const KeyPosition at = times.locate(std::nan(""));
  EXPECT_TRUE(at.on_key);
  EXPECT_EQ(at.key, 0u);
}

}  // namespace
}  // namespace sinew
