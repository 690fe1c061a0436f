// SPDX-License-Identifier: MIT
#include "runtime/base/index.h"
#include "runtime/base/all_below.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(all_below, holds_where_every_index_is_smaller) {
  for (const std::uint32_t count : {1u, 2u, 255u, 65536u, 0x7fffffffu, 0x80000000u})
    for (const std::size_t size : {std::size_t{1}, std::size_t{7}, std::size_t{64}})
      EXPECT_TRUE(all_below(std::vector<std::uint32_t>(size, count - 1), count)) << count;
  EXPECT_TRUE(all_below(std::vector<std::uint32_t>(), 0));
}

TEST(all_below, one_index_too_large_is_seen_anywhere) {
  for (const std::uint32_t count : {0u, 1u, 255u, 65536u, 0x7fffffffu, 0x80000000u})
    for (const std::uint32_t bad : {count, count + 1, 0x7fffffffu, 0x80000000u, 0xffffffffu, 0x80000000u + count})
      for (std::size_t at = 0; at < 19 && bad >= count; ++at) {
        std::vector<std::uint32_t> indices(19, count > 0 ? count - 1 : 0);
        indices[at] = bad;
        EXPECT_FALSE(all_below(indices, count)) << bad << " of " << count << " at " << at;
      }
}

TEST(all_below, counts_past_the_trick_are_compared_one_by_one) {
  EXPECT_TRUE(all_below(std::vector<std::uint32_t>{0x80000001u}, 0x80000002u));
  EXPECT_FALSE(all_below(std::vector<std::uint32_t>{0x80000002u}, 0x80000002u));
  EXPECT_TRUE(all_below(std::vector<std::uint32_t>{0xffffffffu}, std::size_t{1} << 32));
}

TEST(all_below, takes_small_indices) {
  EXPECT_TRUE(all_below(std::vector<std::uint16_t>{0, 65535}, 65536));
  EXPECT_FALSE(all_below(std::vector<std::uint16_t>{0, 65535}, 65535));
}

}  // namespace
}  // namespace sinew
