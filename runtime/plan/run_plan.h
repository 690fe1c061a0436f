// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/result.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_buffer.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// Runs every stage of the plan for one character; afterwards `frame.result()` holds the outcome. What has not changed
/// since the frame before is not done again (P19): the same input costs nothing, an unchanged palette and unchanged
/// weights deform nothing, what nobody sees is not deformed, and a character that sleeps does no work at all. err
/// index_out_of_range (clip, mask); size_mismatch (weights, instances, more layers than Needs::max_layers, or a frame
/// buffer of
///      another plan); not_finite (layer time or weight, morph weight); unsupported (a layer of negative weight, of
///      weight below 1 in a plan without blending, or one that adds without Needs::additive). After an error the frame
///      buffer still holds its last good frame.
/// cost the sum of the plan's stages, no allocation; the same input gives the same bits, whatever ran before
ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept;

}  // namespace sinew
