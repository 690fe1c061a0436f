// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "runtime/geometry_cache/block_motion.h"

namespace sinew {

/// The values of one block in grid steps: x of all points, then y, then z.
using BlockValues = std::array<double, kBlockNumbers>;
using BlockState = std::array<std::int32_t, kBlockNumbers>;

/// An encoded block of one frame.
struct FittedBlock {
  BlockMotion motion;
  BlockState residuals{};
  BlockState state{};  ///< decoded values
};

/// Encodes a block of a key frame.
/// in   values   of the first `count` points; the rest is ignored
///      corners  [3 * 64] as PointOrder::corners
///      reach    largest error of a decoded point, in steps; at least half the diagonal of a grid cell
FittedBlock fit_in_space(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners,
                         double reach);

/// Encodes a block of a delta frame: tries all motion models and takes the one with the fewest bits.
/// in   x1, x2   decoded states one and two frames before;   steady  false = do not use x2
FittedBlock fit_in_time(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners,
                        const BlockState& x1, const BlockState& x2, bool steady, double reach);

}  // namespace sinew
