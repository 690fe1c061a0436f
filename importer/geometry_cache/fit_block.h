// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "runtime/geometry_cache/block_motion.h"

namespace sinew {

/// The values of one block in steps: the x of its points, then y, then z.
using BlockValues = std::array<double, kBlockNumbers>;
using BlockState = std::array<std::int32_t, kBlockNumbers>;

/// One block of one frame as it is stored.
struct FittedBlock {
  BlockMotion motion;
  BlockState residuals{};
  BlockState state{};  ///< what the decoder makes of them
};

/// A block of a key frame.
/// in   values   of the first `count` points, the rest is ignored
///      corners  [3 * 64]
///      reach    largest distance of a decoded point from its value, in steps; at least half the diagonal of a cube
FittedBlock fit_in_space(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners,
                         double reach);

/// A block of another frame: tries what it may follow from, and takes what leaves the fewest bits.
/// in   x1, x2   states one and two frames before; `steady` false: x2 is of no use
FittedBlock fit_in_time(const BlockValues& values, std::size_t count, std::span<const std::uint8_t> corners,
                        const BlockState& x1, const BlockState& x2, bool steady, double reach);

}  // namespace sinew
