// SPDX-License-Identifier: MIT
#include "importer/topology/weld.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

TEST(weld, answers_the_first_vertex_with_the_same_key) {
  const std::vector<float> keys{1, 2, 3, 4, 1, 2, 5, 6, 3, 4};
  EXPECT_THAT(weld(keys, 2), testing::ElementsAre(0, 1, 0, 3, 1));
}

TEST(weld, takes_negative_zero_for_zero) {
  EXPECT_THAT(weld(std::vector<float>{0.0f, -0.0f}, 1), testing::ElementsAre(0, 0));
}

TEST(weld, of_nothing_is_empty) { EXPECT_TRUE(weld({}, 3).empty()); }

TEST(weld, agrees_with_a_plain_search_on_random_keys) {
  test::FixedRandom random(7);
  std::vector<float> keys;
  for (int i = 0; i < 3 * 2000; ++i) keys.push_back(static_cast<float>(random.below(9)) - 4.0f);
  const auto first = weld(keys, 3);
  for (std::size_t v = 0; v < first.size(); ++v) {
    std::size_t expected = 0;
    while (!std::equal(&keys[3 * v], &keys[3 * v] + 3, &keys[3 * expected])) ++expected;
    ASSERT_EQ(first[v], expected) << "vertex " << v;
  }
}

}  // namespace
}  // namespace sinew
