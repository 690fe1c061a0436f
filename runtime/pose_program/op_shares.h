// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew {

/// Share of each operation's pose in the final pose of a program, for events and sounds of the clips that it samples.
/// Masks count as 1, so a share is that of the joints where all masks are 1.
/// eq   1 for the last operation; an operand gets the share s of the operation that takes it times
///      mean              w / (sum w + max(0, threshold - sum w))
///      overlays          min(1, w) for the upper pose, 1 - min(1, w) for the lower one
///      additions         1 for the base, w for the layer, 0 for the reference
///      transitions       1 for the target's pose now, 0 for the others, which do not play any more
///      other operations  1
/// in   program  that find_fault accepts
/// out  shares[operations]     cost O(operations), no allocation
SINEW_API void find_op_shares(PoseProgramSpan program, std::span<float> shares) noexcept;

}  // namespace sinew
