// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/result.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_buffer.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// Runs the stages of the plan for one character; afterwards `frame.result()` holds the outcome. What has not changed
/// since the frame before is not done again: the same input runs no stage, an unchanged palette and unchanged weights
/// deform nothing, what nobody sees is not deformed, and a character that sleeps does no work at all.
/// in   frame  made for this plan: a plan that was compiled anew needs a new buffer
/// err  size_mismatch       a frame buffer of another plan, or one that follows such a buffer; weights, instances,
/// sources,
///                          more
///                          layers than Needs::max_layers
///      index_out_of_range  clip, also one that came to the scene after the plan was compiled; mask; a source that has
///                          no vertices for its instance
///      not_finite          layer time or weight, morph weight, root, time or weight of a source
///      unsupported         a layer of negative weight, of weight below 1 in a plan without blending, or one that adds
///                          without Needs::additive; an interpolation factor outside [0, 1], or not 0 without
///                          Needs::between_updates; a source of weight outside [0, 1], at two times in one frame, or
///                          in scene space for an instance with copies
///      After an error the frame buffer still holds its last good frame.
/// cost the sum of the plan's stages, no allocation; the same input gives the same bits, whatever ran before
ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept;

/// Whether the buffer holds the result of this very input, so that run_plan would run no stage.
/// cost O(layers + weights + instances), no allocation
bool holds_result_of(const FrameBuffer& frame, const FrameInput& input) noexcept;

}  // namespace sinew
