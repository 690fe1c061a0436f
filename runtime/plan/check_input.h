// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_buffer.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/refusal.h"

namespace sinew {

/// The largest weight of a layer, morph weight, and number of a root matrix. Blended sums, products of matrices and the
/// lengths of normals overflow from about 1e18 on.
inline constexpr float kLargestInput = 1e9f;

/// Checks an input by the rules that run_plan documents.     cost O(layers + weights + sources). Internal to plan/
Refusal check_input(const CompiledPlan& plan, const FrameInput& input) noexcept;

/// Checks that the buffers have memory and were made for this plan.
/// in   followed  the buffer given to FrameBuffer::follow; null = none
Refusal check_buffers(const Plan& plan, const FrameBuffer& frame, const FrameBuffer* followed) noexcept;

/// check_buffers, then check_input.
Refusal check_run(const Plan& plan, const FrameInput& input, const FrameBuffer& frame,
                  const FrameBuffer* followed) noexcept;

}  // namespace sinew
