// SPDX-License-Identifier: MIT
// How a frame of points follows from the frames before it. The encoder predicts and the decoder moves by the same
// equations, in integers that wrap, so both have the same bits on every machine.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "runtime/base/run_job.h"

namespace sinew {

/// Points are predicted in blocks of this many neighbours. The last block of a stream is padded with points that are
/// never shown.
inline constexpr std::size_t kBlockPoints = 64;
/// Integers of one block: the x of all its points, then y, then z.
inline constexpr std::size_t kBlockNumbers = 3 * kBlockPoints;
inline constexpr std::uint8_t kMaxWidth = 32;
/// Bytes after the last packed residual that SIMD loads may read.
inline constexpr std::size_t kPayloadPadding = 16;
/// Stands for a missing corner of a parallelogram.
inline constexpr std::uint8_t kNoCorner = kBlockPoints;

/// The prediction that residuals of a block are added to. x1 and x2 are the point one and two frames earlier.
enum class BlockBase : std::uint8_t {
  space,   ///< key frame: 0. Residuals spread by the parallelogram rule: a + b - c of earlier points
  last,    ///< x1
  linear,  ///< 2 x1 - x2: constant velocity
  slower,  ///< x1 + (x1 - x2) / 2, rounded down
};

/// Motion of one block from frame to frame.
/// eq   x = base + offset + ((M (x1 - first) + 2^(shift-1)) >> shift) + r,  `first` is the x1 of the block's point 0
///      r = residual, or if residuals spread over the surface: r = residual + r[a] + r[b] - r[c]
struct BlockMotion {
  BlockBase base = BlockBase::last;
  bool turns = false;                    ///< M is present: the block also turns, stretches and shears
  bool spreads = false;                  ///< residuals are predicted from neighbours, as in `space`
  std::uint8_t shift = 0;                ///< bits by which the product with M is shifted right, 0 to 30
  std::array<std::uint8_t, 3> width{};   ///< bits of each residual along x, y, z
  std::array<std::int16_t, 9> matrix{};  ///< column by column
  std::array<std::int32_t, 3> offset{};
};

/// Moves the blocks of one stream on by one frame.
/// err  size_mismatch, index_out_of_range     cost O(points), no allocation
struct MoveBlocksJob {
  std::span<const BlockMotion> blocks;
  std::span<const std::uint8_t> payload;  ///< packed zigzag residuals: 8 * width bytes per block and axis, then padding
  std::span<const std::uint8_t> corners;  ///< [3 * 64 * blocks] a, b, c of each point, below 64, or kNoCorner
  std::span<const std::int32_t> x1, x2;   ///< [192 * blocks] numbers one and two frames earlier
  std::span<std::int32_t> x;              ///< [192 * blocks] may be x2
};
ErrorCode check(const MoveBlocksJob& job) noexcept;
void run_unchecked(const MoveBlocksJob& job) noexcept;

/// Converts the integers of two frames to points in metres.
/// eq   out = step ((1 - part) from + part to), each product and sum rounded to float by itself; `to` alone at part 1
/// err  size_mismatch     cost O(points), no allocation
struct EmitPointsJob {
  std::span<const std::int32_t> from, to;  ///< [192 * blocks] numbers of two frames
  float part = 1.0f;                       ///< [0, 1] fraction of the way from `from` to `to`
  float step = 1.0f;                       ///< metres per integer step
  std::span<glm::vec3> out;                ///< [points], at most 64 * blocks
};
ErrorCode check(const EmitPointsJob& job) noexcept;
void run_unchecked(const EmitPointsJob& job) noexcept;

/// Zigzag code: small numbers of either sign become small unsigned numbers, which pack into few bits.
constexpr std::uint32_t zigzag(std::int32_t number) noexcept {
  return static_cast<std::uint32_t>(number) << 1 ^ static_cast<std::uint32_t>(number >> 31);
}
constexpr std::int32_t unzigzag(std::uint32_t number) noexcept {
  return static_cast<std::int32_t>(number >> 1 ^ (0u - (number & 1u)));
}

}  // namespace sinew
