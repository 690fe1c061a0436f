// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/block_headers.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "runtime/geometry_cache/geometry_format.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

std::vector<BlockMotion> any_motions(FixedRandom& random, FramePlace place, unsigned offset_bits) {
  std::vector<BlockMotion> out(1 + random.below(20));
  for (BlockMotion& motion : out) {
    motion.base = place == FramePlace::key      ? BlockBase::space
                  : place == FramePlace::second ? BlockBase::last
                                                : static_cast<BlockBase>(1 + random.below(3));
    motion.turns = place != FramePlace::key && random.below(2) == 0;
    motion.spreads = place != FramePlace::key && random.below(2) == 0;
    for (auto& width : motion.width) width = static_cast<std::uint8_t>(random.below(33));
    for (auto& x : motion.offset)
      x = static_cast<std::int32_t>(static_cast<std::int64_t>(random.bits()) >> (64 - offset_bits));
    if (!motion.turns) continue;
    motion.shift = static_cast<std::uint8_t>(random.below(31));
    for (auto& x : motion.matrix) x = static_cast<std::int16_t>(random.bits());
  }
  return out;
}

bool is_same(const BlockMotion& a, const BlockMotion& b) {
  return a.base == b.base && a.turns == b.turns && a.spreads == b.spreads && a.width == b.width &&
         a.offset == b.offset && (a.turns ? a.shift == b.shift && a.matrix == b.matrix : a.shift == 0);
}

TEST(block_headers, what_was_written_is_read_again) {
  FixedRandom random(7);
  for (const FramePlace place : {FramePlace::key, FramePlace::second, FramePlace::later})
    for (const unsigned bits : {1u, 7u, 8u, 15u, 16u, 23u, 24u, 32u})
      for (int repeat = 0; repeat < 20; ++repeat) {
        const std::vector<BlockMotion> written = any_motions(random, place, bits);
        const BlockHeaderBytes bytes = write_block_headers(written);
        EXPECT_LE(bytes.coarse.size(), most_coarse_bytes(written.size()));
        EXPECT_LE(bytes.fine.size(), most_fine_bytes(written.size()));
        std::vector<BlockMotion> read(written.size(), BlockMotion{.shift = 9, .matrix = {1}, .offset = {1, 2, 3}});
        ASSERT_TRUE(read_block_headers(bytes.coarse, bytes.fine, place, read));
        for (std::size_t b = 0; b < read.size(); ++b) ASSERT_TRUE(is_same(read[b], written[b])) << "block " << b;
      }
}

TEST(block_headers, sections_of_another_size_are_refused) {
  FixedRandom random(8);
  const std::vector<BlockMotion> motions = any_motions(random, FramePlace::later, 12);
  const BlockHeaderBytes bytes = write_block_headers(motions);
  std::vector<BlockMotion> read(motions.size());
  for (std::size_t size = 0; size < bytes.coarse.size(); ++size)
    EXPECT_FALSE(read_block_headers(std::span(bytes.coarse).first(size), bytes.fine, FramePlace::later, read)) << size;
  for (std::size_t size = 0; size < bytes.fine.size(); ++size)
    EXPECT_FALSE(read_block_headers(bytes.coarse, std::span(bytes.fine).first(size), FramePlace::later, read)) << size;
  read.resize(motions.size() + 1);
  EXPECT_FALSE(read_block_headers(bytes.coarse, bytes.fine, FramePlace::later, read));
}

TEST(block_headers, bits_of_kinds_that_mean_nothing_are_refused) {
  BlockMotion motion{.base = BlockBase::last};
  const BlockHeaderBytes good = write_block_headers(std::span(&motion, 1));
  EXPECT_TRUE(read_block_headers(good.coarse, good.fine, FramePlace::later, std::span(&motion, 1)));
  for (const int bit : {16, 32, 64, 128}) {
    BlockHeaderBytes bytes = good;
    bytes.coarse[0] = static_cast<std::uint8_t>(bytes.coarse[0] | bit);  // kinds come first
    EXPECT_FALSE(read_block_headers(bytes.coarse, bytes.fine, FramePlace::later, std::span(&motion, 1))) << bit;
  }
}

TEST(block_headers, kinds_that_a_frame_cannot_have_are_refused) {
  const auto reads = [](BlockMotion motion, FramePlace place) {
    const BlockHeaderBytes bytes = write_block_headers(std::span(&motion, 1));
    return read_block_headers(bytes.coarse, bytes.fine, place, std::span(&motion, 1));
  };
  EXPECT_TRUE(reads({.base = BlockBase::space}, FramePlace::key));
  EXPECT_FALSE(reads({.base = BlockBase::space}, FramePlace::second));
  EXPECT_FALSE(reads({.base = BlockBase::space}, FramePlace::later));
  EXPECT_FALSE(reads({.base = BlockBase::space, .turns = true}, FramePlace::key));
  EXPECT_FALSE(reads({.base = BlockBase::space, .spreads = true}, FramePlace::key));
  EXPECT_FALSE(reads({.base = BlockBase::last}, FramePlace::key));
  EXPECT_TRUE(reads({.base = BlockBase::last, .turns = true}, FramePlace::second));
  for (const BlockBase base : {BlockBase::linear, BlockBase::slower}) {
    EXPECT_FALSE(reads({.base = base}, FramePlace::second)) << "it would follow from a frame of another segment";
    EXPECT_TRUE(reads({.base = base}, FramePlace::later));
  }
  EXPECT_FALSE(reads({.width = {0, 33, 0}}, FramePlace::later));
  EXPECT_FALSE(reads({.turns = true, .shift = 31}, FramePlace::later));
}

TEST(block_headers, the_most_that_sections_take_is_what_the_largest_blocks_take) {
  for (const std::size_t count : {0u, 1u, 7u}) {
    std::vector<BlockMotion> largest(count);
    for (BlockMotion& motion : largest) {
      motion.turns = true;
      motion.offset = {std::numeric_limits<std::int32_t>::min(), 0, 1};
    }
    const BlockHeaderBytes bytes = write_block_headers(largest);
    if (count > 0) {
      EXPECT_EQ(bytes.coarse.size(), most_coarse_bytes(count));
    }
    EXPECT_EQ(most_coarse_bytes(count), 1 + 23 * count);
    EXPECT_EQ(bytes.fine.size(), most_fine_bytes(count));
  }
}

TEST(block_headers, offsets_take_as_many_planes_as_the_largest_has_bytes) {
  const auto planes_of = [](std::int32_t offset, std::size_t axis) {
    std::vector<BlockMotion> blocks(3);
    blocks[1].offset[axis] = offset;
    const BlockHeaderBytes bytes = write_block_headers(blocks);
    EXPECT_EQ(bytes.coarse.size(), 1 + 3 * (4 + 3 * std::size_t{bytes.coarse[0]}));
    return bytes.coarse[0];
  };
  for (const std::size_t axis : {0u, 1u, 2u}) {
    // Zigzag codes: -128 becomes 255, and 128 becomes 256.
    for (const unsigned bytes : {1u, 2u, 3u}) {
      const std::int32_t half = 1 << (8 * bytes - 1);
      EXPECT_EQ(planes_of(-half, axis), bytes - 1) << half;
      EXPECT_EQ(planes_of(half - 1, axis), bytes - 1) << half;
      EXPECT_EQ(planes_of(half, axis), bytes) << half;
    }
    EXPECT_EQ(planes_of(0, axis), 0);
  }
}

TEST(block_headers, offsets_of_key_frames_count_from_the_block_before) {
  std::vector<BlockMotion> blocks(4, BlockMotion{.base = BlockBase::space, .offset = {100000, -100000, 7}});
  blocks[3].offset = {100003, -100001, 7};
  const BlockHeaderBytes bytes = write_block_headers(blocks);
  // Lowest bytes of zigzag differences, axis by axis: 200000, 0, 0, 6; 199999, 0, 0, 1; 14, 0, 0, 0.
  const std::vector<std::uint8_t> expected = {200000 & 255, 0, 0, 6, 199999 & 255, 0, 0, 1, 14, 0, 0, 0};
  EXPECT_EQ(bytes.fine, expected);
  for (BlockMotion& motion : blocks) motion.base = BlockBase::last;
  EXPECT_EQ(write_block_headers(blocks).fine[1], 200000 & 255) << "others stand alone";
}

TEST(block_headers, limits_are_inside) {
  const auto reads = [](BlockMotion motion) {
    const BlockHeaderBytes bytes = write_block_headers(std::span(&motion, 1));
    return read_block_headers(bytes.coarse, bytes.fine, FramePlace::later, std::span(&motion, 1));
  };
  for (const std::size_t axis : {0u, 1u, 2u}) {
    BlockMotion motion;
    motion.width[axis] = 32;
    EXPECT_TRUE(reads(motion));
    motion.width[axis] = 33;
    EXPECT_FALSE(reads(motion)) << axis;
  }
  EXPECT_TRUE(reads({.turns = true, .shift = 30}));
  BlockMotion any;
  for (const std::uint8_t kind : {std::uint8_t{15}, std::uint8_t{16}, std::uint8_t{32}}) {
    std::vector<std::uint8_t> coarse = write_block_headers(std::span(&any, 1)).coarse, fine(3 + 9, 0);
    coarse[1] = kind;
    if ((kind & kTurnsBit) != 0) {
      coarse.resize(coarse.size() + 10, 0);
    } else {
      fine.resize(3);
    }
    EXPECT_EQ(read_block_headers(coarse, fine, FramePlace::later, std::span(&any, 1)), kind == 15) << int{kind};
  }
  std::vector<std::uint8_t> coarse(1 + 4 + 3 * 4, 0);
  coarse[0] = 4;  // number of planes, one more than allowed
  coarse[1] = static_cast<std::uint8_t>(BlockBase::last);
  EXPECT_FALSE(read_block_headers(coarse, std::vector<std::uint8_t>(3, 0), FramePlace::later, std::span(&any, 1)));
}

}  // namespace
}  // namespace sinew::test
