// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/block_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "runtime/geometry_cache/geometry_format.h"
#include "tests/reference/block_motion.h"
#include "tests/support/fixed_random.h"
#include "tests/support/simd_targets.h"

namespace sinew::test {
namespace {

/// Blocks with random values in all fields.
struct AnyBlocks {
  std::vector<BlockMotion> motions;
  std::vector<std::uint8_t> payload, corners;
  std::vector<std::int32_t> x1, x2;
};

std::int32_t number_of_bits(FixedRandom& random, unsigned bits) {
  return static_cast<std::int32_t>(static_cast<std::int64_t>(random.bits()) >> (64 - bits));
}

BlockMotion any_motion(FixedRandom& random, BlockBase base, unsigned state_bits) {
  BlockMotion motion{.base = base, .turns = base != BlockBase::space && random.below(2) == 0};
  motion.spreads = base != BlockBase::space && random.below(3) == 0;
  motion.shift = static_cast<std::uint8_t>(random.below(31));
  for (auto& width : motion.width) width = static_cast<std::uint8_t>(random.below(kMaxWidth + 1));
  for (auto& number : motion.matrix) number = static_cast<std::int16_t>(random.bits());
  for (auto& number : motion.offset) number = number_of_bits(random, state_bits);
  return motion;
}

AnyBlocks any_blocks(std::uint64_t seed, std::size_t count, unsigned state_bits) {
  FixedRandom random(seed);
  AnyBlocks out;
  for (std::size_t b = 0; b < count; ++b)
    out.motions.push_back(any_motion(random, static_cast<BlockBase>(random.below(4)), state_bits));
  out.payload.resize(payload_bytes(out.motions) + kPayloadPadding);
  for (auto& byte : out.payload) byte = static_cast<std::uint8_t>(random.bits());
  for (std::size_t i = 0; i < count * kBlockPoints; ++i)
    for (int k = 0; k < 3; ++k) {
      const auto place = static_cast<std::uint32_t>(i % kBlockPoints);
      out.corners.push_back(place == 0 || random.below(4) == 0 ? kNoCorner
                                                               : static_cast<std::uint8_t>(random.below(place)));
    }
  for (auto* state : {&out.x1, &out.x2})
    for (std::size_t i = 0; i < count * kBlockNumbers; ++i) state->push_back(number_of_bits(random, state_bits));
  return out;
}

std::vector<std::int32_t> moved_by_reference(const AnyBlocks& in) {
  std::vector<std::int32_t> x = in.x2;
  std::span<const std::uint8_t> payload = in.payload;
  for (std::size_t b = 0; b < in.motions.size(); ++b) {
    const auto block = [&](auto& all) { return std::span(all).subspan(b * kBlockNumbers, kBlockNumbers); };
    reference::move_block(in.motions[b], payload, block(in.corners), block(in.x1), block(in.x2), block(x));
    payload = payload.subspan(payload_bytes(std::span(&in.motions[b], 1)));
  }
  return x;
}

TEST(block_motion, every_instruction_set_moves_blocks_as_the_equation_says) {
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    for (const unsigned bits : {4u, 14u, 24u, 32u})
      for (std::uint64_t seed = 1; seed < 30; ++seed) {
        AnyBlocks in = any_blocks(seed, 20, bits);
        const std::vector<std::int32_t> expected = moved_by_reference(in);
        EXPECT_EQ(run(MoveBlocksJob{.blocks = in.motions,
                                    .payload = in.payload,
                                    .corners = in.corners,
                                    .x1 = in.x1,
                                    .x2 = in.x2,
                                    .x = in.x2}),
                  ErrorCode::ok);
        ASSERT_EQ(in.x2, expected) << simd_name(target) << ", numbers of " << bits << " bits, seed " << seed;
      }
  }
}

TEST(block_motion, every_width_of_residuals_is_unpacked) {
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    for (std::uint8_t width = 0; width <= kMaxWidth; ++width) {
      AnyBlocks in = any_blocks(width + 1u, 1, 20);
      in.motions = {BlockMotion{.base = BlockBase::last, .width = {width, width, width}}};
      in.payload.assign(std::size_t{24} * width + kPayloadPadding, 0);
      FixedRandom random(width);
      for (auto& byte : in.payload) byte = static_cast<std::uint8_t>(random.bits());
      const std::vector<std::int32_t> expected = moved_by_reference(in);
      EXPECT_EQ(run(MoveBlocksJob{.blocks = in.motions,
                                  .payload = in.payload,
                                  .corners = in.corners,
                                  .x1 = in.x1,
                                  .x2 = in.x2,
                                  .x = in.x2}),
                ErrorCode::ok);
      ASSERT_EQ(in.x2, expected) << simd_name(target) << ", width " << int{width};
    }
  }
}

TEST(block_motion, a_parallelogram_by_hand) {
  // Points 0, 1, 2 are known; point 3 = 1 + 2 - 0 + residual. Residuals: 0, 10, 1, -1 along x, nothing along y and z.
  BlockMotion motion{.base = BlockBase::space, .width = {5, 0, 0}, .offset = {100, 7, -7}};
  std::vector<std::uint8_t> payload(40 + kPayloadPadding, 0), corners(kBlockNumbers, kNoCorner);
  std::uint64_t packed = 0;
  const std::int32_t residuals[] = {0, 10, 1, -1};
  for (unsigned i = 0; i < 4; ++i) packed |= std::uint64_t{zigzag(residuals[i])} << (5 * i);
  for (unsigned byte = 0; byte < 8; ++byte) payload[byte] = static_cast<std::uint8_t>(packed >> (8 * byte));
  corners[9] = 1;
  corners[10] = 2;
  corners[11] = 0;
  std::vector<std::int32_t> x(kBlockNumbers), unused(kBlockNumbers);
  EXPECT_EQ(
      run(MoveBlocksJob{
          .blocks = std::span(&motion, 1), .payload = payload, .corners = corners, .x1 = unused, .x2 = unused, .x = x}),
      ErrorCode::ok);
  EXPECT_EQ(std::vector<std::int32_t>(x.begin(), x.begin() + 4), (std::vector<std::int32_t>{100, 110, 101, 110}));
  EXPECT_EQ(x[kBlockPoints], 7);
  EXPECT_EQ(x[2 * kBlockPoints + 63], -7);
}

TEST(block_motion, buffers_of_other_sizes_and_too_wide_residuals_are_refused) {
  BlockMotion motion{.width = {1, 0, 0}};
  std::vector<std::int32_t> numbers(kBlockNumbers), x(kBlockNumbers);
  std::vector<std::uint8_t> corners(kBlockNumbers, kNoCorner), payload(8 + kPayloadPadding);
  const auto job = [&] { return MoveBlocksJob{{&motion, 1}, payload, corners, numbers, numbers, x}; };
  EXPECT_EQ(check(job()), ErrorCode::ok);
  payload.pop_back();
  EXPECT_EQ(run(job()), ErrorCode::size_mismatch) << "the padding is read too";
  payload.push_back(0);
  corners.pop_back();
  EXPECT_EQ(run(job()), ErrorCode::size_mismatch);
  corners.push_back(kNoCorner);
  motion.width[1] = kMaxWidth + 1;
  EXPECT_EQ(run(job()), ErrorCode::index_out_of_range);

  std::vector<glm::vec3> points(kBlockPoints + 1);
  EXPECT_EQ(run(EmitPointsJob{.from = numbers, .to = x, .out = points}), ErrorCode::size_mismatch);
  points.pop_back();
  EXPECT_EQ(run(EmitPointsJob{.from = numbers, .to = x, .out = points}), ErrorCode::ok);
  x.pop_back();
  EXPECT_EQ(run(EmitPointsJob{.from = numbers, .to = x, .out = points}), ErrorCode::size_mismatch);
}

TEST(block_motion, points_are_written_with_the_same_bits_by_every_instruction_set) {
  FixedRandom random(3);
  for (const std::size_t points : {1u, 63u, 64u, 65u, 200u}) {
    std::vector<std::int32_t> from((points + 63) / 64 * kBlockNumbers), to = from;
    for (auto* state : {&from, &to})
      for (auto& x : *state) x = number_of_bits(random, 26);
    for (const float part : {0.0f, 0.3f, 1.0f})
      for (const std::int64_t target : simd_targets()) {
        const OnlyTarget only(target);
        std::vector<glm::vec3> out(points);
        EXPECT_EQ(run(EmitPointsJob{.from = from, .to = to, .part = part, .step = 1e-4f, .out = out}), ErrorCode::ok);
        for (std::size_t i = 0; i < points; ++i)
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t at = i / 64 * kBlockNumbers + axis * kBlockPoints + i % 64;
            const float a = static_cast<float>(from[at]) * 1e-4f, b = static_cast<float>(to[at]) * 1e-4f;
            const float one = a * (1.0f - part), other = b * part;
            ASSERT_EQ(out[i][static_cast<int>(axis)], part == 1.0f ? b : one + other)
                << simd_name(target) << " point " << i;
          }
      }
  }
}

TEST(block_motion, zigzag_goes_both_ways) {
  EXPECT_EQ(zigzag(0), 0u);
  EXPECT_EQ(zigzag(-1), 1u);
  EXPECT_EQ(zigzag(1), 2u);
  for (const std::int32_t x : {0, 1, -1, 77, -78, 0x7fffffff, -0x7fffffff - 1}) EXPECT_EQ(unzigzag(zigzag(x)), x);
}

}  // namespace
}  // namespace sinew::test
