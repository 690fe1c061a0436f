// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/residual_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "importer/geometry_cache/code_residuals.h"
#include "runtime/base/bit_hash.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

/// Blocks whose residuals have a mean size of their own for each axis; some are zero, some of any size.
std::vector<FittedBlock> any_blocks(std::uint64_t seed, std::size_t count) {
  FixedRandom random(seed);
  std::vector<FittedBlock> out(count);
  for (FittedBlock& block : out) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double mean = random.below(5) == 0 ? 0.0 : std::pow(10.0, random.in(-1.5, 5.0));
      for (std::size_t i = 0; i < kBlockPoints; ++i) {
        const double size = -std::log(random.in(1e-6, 1.0)) * mean;
        const bool down = random.below(2) == 0;
        block.residuals[axis * kBlockPoints + i] = static_cast<std::int32_t>(down ? -size : size);
      }
    }
    if (random.below(4) == 0) block.residuals[random.below(kBlockNumbers)] = static_cast<std::int32_t>(random.bits());
    block.motion.width = {kMaxWidth, kMaxWidth, kMaxWidth};
    choose_codes(block);
  }
  return out;
}

constexpr std::uint64_t kWordHash = 16320589900613012797u;

std::vector<BlockMotion> motions_of(const std::vector<FittedBlock>& blocks) {
  std::vector<BlockMotion> out;
  for (const FittedBlock& block : blocks) out.push_back(block.motion);
  return out;
}

bool read(const std::vector<BlockMotion>& motions, std::vector<std::uint8_t> codes, std::vector<std::uint8_t>& uppers) {
  codes.resize(codes.size() + kCodePadding, 0xa5);
  uppers.assign(motions.size() * kBlockNumbers, 0xee);
  return read_uppers(motions, codes, uppers);
}

TEST(residual_code, what_was_coded_is_read_again) {
  for (std::uint64_t seed = 1; seed < 40; ++seed) {
    const std::vector<FittedBlock> blocks = any_blocks(seed, 1 + seed);
    const std::vector<std::uint8_t> codes = write_codes(blocks);
    EXPECT_LE(codes.size(), most_code_bytes(blocks.size()));
    std::vector<std::uint8_t> uppers;
    ASSERT_TRUE(read(motions_of(blocks), codes, uppers));
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (std::size_t n = 0; n < kBlockNumbers; ++n) {
        const std::size_t axis = n / kBlockPoints;
        const std::uint8_t width = blocks[b].motion.width[axis];
        const bool coded = blocks[b].motion.code[axis] > 0;
        ASSERT_EQ(uppers[b * kBlockNumbers + n], coded ? zigzag(blocks[b].residuals[n]) >> width : 0) << b << ", " << n;
      }
  }
}

TEST(residual_code, no_word_begins_another_and_together_they_are_all_bits) {
  BitHash hash;
  for (std::uint8_t code = 1; code <= kResidualCodes; ++code) {
    std::vector<bool> taken(std::size_t{1} << kMaxWordBits);
    const auto take = [&](std::uint32_t bits, unsigned length) {
      ASSERT_GT(length, 0u);
      ASSERT_LE(length, kMaxWordBits);
      for (std::size_t at = bits; at < taken.size(); at += std::size_t{1} << length) {
        EXPECT_FALSE(taken[at]) << "code " << int{code};
        taken[at] = true;
      }
      hash.add(std::span<const std::uint32_t>(std::array{bits, std::uint32_t{length}}));
    };
    for (std::uint32_t a = 0; a < kWordUppers; ++a)
      for (std::uint32_t b = 0; b < kWordUppers; ++b)
        if (const PairBits pair = bits_of_pair(code, a, b); pair.length <= kMaxWordBits) take(pair.bits, pair.length);
    const PairBits escaped = bits_of_pair(code, kMaxUpper, 7);
    const unsigned length = escaped.length - 2 * kRawUpperBits;
    EXPECT_EQ(escaped.bits >> length, kMaxUpper | 7 << kRawUpperBits);
    take(escaped.bits & ((1u << length) - 1), length);
    EXPECT_EQ(std::count(taken.begin(), taken.end(), false), 0) << "code " << int{code};
  }
  EXPECT_EQ(hash.value(), kWordHash) << "files that were written have these words";
}

TEST(residual_code, codes_come_near_the_entropy_of_what_is_coded) {
  // Order-0 entropy of two-sided geometric residuals of a known mean, which no code of single blocks can be below.
  FixedRandom random(9);
  for (const double mean : {0.15, 0.4, 0.9, 2.0, 4.5, 11.0, 70.0, 3000.0}) {
    const double q = (std::sqrt(1.0 + mean * mean) - 1.0) / mean;
    const double entropy = std::log2((1.0 + q) / (1.0 - q)) - mean * std::log2(q);
    std::size_t bits = 0;
    constexpr int kBlocks = 60;
    for (int round = 0; round < kBlocks; ++round) {
      FittedBlock block;
      block.motion.width = {kMaxWidth, kMaxWidth, kMaxWidth};
      for (std::int32_t& r : block.residuals) {
        r = random.in(0.0, 1.0) < (1.0 - q) / (1.0 + q)
                ? 0
                : 1 + static_cast<std::int32_t>(std::log(random.in(1e-12, 1.0)) / std::log(q));
        if (random.below(2) == 0) r = -r;
      }
      choose_codes(block);
      for (std::size_t n = 0; n < kBlockNumbers; n += 2) {
        const std::size_t axis = n / kBlockPoints;
        const std::uint8_t width = block.motion.width[axis], code = block.motion.code[axis];
        bits += std::size_t{2} * width;
        if (code > 0)
          bits +=
              bits_of_pair(code, zigzag(block.residuals[n]) >> width, zigzag(block.residuals[n + 1]) >> width).length;
      }
    }
    const double each = static_cast<double>(bits) / (kBlocks * kBlockNumbers);
    EXPECT_LT(each, 1.04 * entropy + 0.06) << "mean " << mean << ": " << each << " of " << entropy << " bits";
    EXPECT_GT(each, 0.9 * entropy) << "mean " << mean;
  }
}

TEST(residual_code, words_that_end_elsewhere_than_the_codes_are_refused) {
  const std::vector<FittedBlock> blocks = any_blocks(3, 9);
  const std::vector<BlockMotion> motions = motions_of(blocks);
  const std::vector<std::uint8_t> good = write_codes(blocks);
  std::vector<std::uint8_t> uppers;
  ASSERT_TRUE(read(motions, good, uppers));
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_FALSE(read(motions, {good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)}, uppers)) << size;
  std::vector<std::uint8_t> bytes = good;
  bytes.push_back(0);
  EXPECT_FALSE(read(motions, bytes, uppers));
  for (const std::size_t head : {0u, 4u})
    for (const std::uint32_t wrong : {0u, 0x7fffffffu, 0xffffffffu, 1u + good[head]}) {
      bytes = good;
      std::memcpy(bytes.data() + head, &wrong, sizeof(wrong));
      EXPECT_FALSE(read(motions, bytes, uppers)) << head << ", " << wrong;
    }
}

TEST(residual_code, any_bytes_are_read_within_their_padding) {
  FixedRandom random(4);
  const std::vector<BlockMotion> motions = motions_of(any_blocks(5, 12));
  std::vector<std::uint8_t> uppers;
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::uint8_t> codes(kCodeHeads + random.below(1200));
    for (std::uint8_t& byte : codes) byte = static_cast<std::uint8_t>(random.below(3) == 0 ? 255 : random.bits());
    const auto size = static_cast<std::uint32_t>(codes.size() - kCodeHeads);
    const std::uint32_t heads[2] = {random.below(size + 1), random.below(size + 1)};
    std::memcpy(codes.data(), heads, sizeof(heads));
    read(motions, codes, uppers);  // sanitizers see reads outside
  }
}

}  // namespace
}  // namespace sinew::test
