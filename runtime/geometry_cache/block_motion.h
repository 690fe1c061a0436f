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

/// Points are predicted in blocks of so many neighbours. The last block of a stream is filled up with points that are
/// never shown.
inline constexpr std::size_t kBlockPoints = 64;
/// Numbers of a block in a state: the x of all its points, then y, then z.
inline constexpr std::size_t kBlockNumbers = 3 * kBlockPoints;
inline constexpr std::uint8_t kMostWidth = 32;
/// Bytes that may be read after the last packed residual.
inline constexpr std::size_t kPayloadPadding = 16;
/// In place of a corner of a parallelogram that does not exist.
inline constexpr std::uint8_t kNoCorner = kBlockPoints;

/// What residuals of a block are added to. x1 and x2 are the point one and two frames before.
enum class BlockBase : std::uint8_t {
  space,   ///< key frame: 0, and residuals spread: a + b - c of points that come before (a parallelogram)
  last,    ///< x1
  linear,  ///< 2 x1 - x2: the same velocity again
  slower,  ///< x1 + (x1 - x2) / 2, rounded down
};

/// The motion of one block from frame to frame.
/// eq   x = base + offset + ((M (x1 - first) + 2^(shift-1)) >> shift) + r,  `first` the x1 of the block's point 0
///      r = residual, or where residuals spread over the surface: r = residual + r[a] + r[b] - r[c]
struct BlockMotion {
  BlockBase base = BlockBase::last;
  bool turns = false;                    ///< M is there: the block also turns, stretches and shears
  bool spreads = false;                  ///< what the motion misses goes on from neighbour to neighbour, as in `space`
  std::uint8_t shift = 0;                ///< [0, 30]
  std::array<std::uint8_t, 3> width{};   ///< bits of each residual along x, y, z
  std::array<std::int16_t, 9> matrix{};  ///< column by column
  std::array<std::int32_t, 3> offset{};
};

/// Moves the blocks of one stream on by a frame.
struct MoveBlocksJob {
  std::span<const BlockMotion> blocks;
  std::span<const std::uint8_t> payload;  ///< residuals, zigzag coded and packed: for each block and axis 8 * width
                                          ///< bytes; and kPayloadPadding more
  std::span<const std::uint8_t> corners;  ///< [3 * 64 * blocks] a, b, c of each point, below 64, or kNoCorner
  std::span<const std::int32_t> x1, x2;   ///< [192 * blocks]
  std::span<std::int32_t> x;              ///< [192 * blocks] may be x2
};
ErrorCode check(const MoveBlocksJob& job) noexcept;
void run_unchecked(const MoveBlocksJob& job) noexcept;

/// Points of a state, in metres.
/// eq   out = step ((1 - part) from + part to), each product and sum rounded to float by itself; `to` alone at part 1
struct EmitPointsJob {
  std::span<const std::int32_t> from, to;  ///< [192 * blocks] of two frames
  float part = 1.0f;                       ///< [0, 1]
  float step = 1.0f;                       ///< metres
  std::span<glm::vec3> out;                ///< [points], at most 64 * blocks
};
ErrorCode check(const EmitPointsJob& job) noexcept;
void run_unchecked(const EmitPointsJob& job) noexcept;

/// Residuals have a small number of bits where small numbers of either sign are small numbers.
constexpr std::uint32_t zigzag(std::int32_t number) noexcept {
  return static_cast<std::uint32_t>(number) << 1 ^ static_cast<std::uint32_t>(number >> 31);
}
constexpr std::int32_t unzigzag(std::uint32_t number) noexcept {
  return static_cast<std::int32_t>(number >> 1 ^ (0u - (number & 1u)));
}

}  // namespace sinew
