// SPDX-License-Identifier: MIT
// A geometry cache of an earlier version decodes to the stored bits, on every instruction set and machine.
// tests/geometry_cache/golden_cache_test.cpp writes the file.
#include <gtest/gtest.h>

#include <fstream>
#include <ios>
#include <string>

#include "tests/golden/decoded_hash.h"
#include "tests/support/simd_targets.h"

namespace sinew::test {
namespace {

TEST(golden_decoder, a_stored_cache_has_the_stored_bits_on_every_instruction_set) {
  const std::string path = SINEW_SOURCE_DIR "/tests/golden/cloth.sgeo";
  const std::vector<std::byte> file = bytes_of_file(path);
  ASSERT_TRUE(GeometryCache::open(file).has_value()) << "files of version 1 stay readable";
  std::uint64_t stored = 0;
  std::ifstream(path + ".txt") >> std::hex >> stored;
  ASSERT_NE(stored, 0u);
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    EXPECT_EQ(decoded_hash(file), stored) << simd_name(target);
  }
}

}  // namespace
}  // namespace sinew::test
