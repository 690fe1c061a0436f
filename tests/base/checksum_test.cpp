// SPDX-License-Identifier: MIT
#include "runtime/base/checksum.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string_view>
#include <vector>

namespace sinew {
namespace {

std::uint64_t of(std::string_view text, std::uint64_t seed = 0) {
  return checksum(std::as_bytes(std::span<const char>(text)), seed);
}

// Values from xxHash's own program: `printf abc | xxhsum -H3`.
TEST(checksum, has_the_published_numbers_of_xxh3) {
  EXPECT_EQ(of(""), 0x2d06800538d394c2u);
  EXPECT_EQ(of("abc"), 0x78af5f94892f3950u);
}

TEST(checksum, every_byte_counts_and_so_do_the_arrays_before) {
  std::vector<std::byte> bytes(300);
  std::set<std::uint64_t> seen{checksum(bytes)};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = std::byte{1};
    EXPECT_TRUE(seen.insert(checksum(bytes)).second) << i;
    bytes[i] = std::byte{0};
  }
  EXPECT_EQ(seen.size(), bytes.size() + 1);
  EXPECT_NE(of("a", of("b")), of("a", of("c")));
  EXPECT_NE(of("a", of("b")), of("b", of("a")));
}

}  // namespace
}  // namespace sinew
