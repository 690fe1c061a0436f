// SPDX-License-Identifier: MIT
#pragma once
/// A frame of one character: FrameInput says which clips play at which times, run_plan evaluates them, and FrameResult
/// has joints, palettes and vertices. FrameBuffer is all memory of a character; frames allocate nothing.
///
///     sinew::FrameBuffer frame(plan);
///     const sinew::ClipLayer layers[] = {{.clip = 0, .time_s = clock.time_s()}};
///     if (run_plan(plan, {.layers = layers}, frame) != sinew::ErrorCode::ok) return;
///     for (const sinew::DeformedPrimitive& primitive : frame.result().primitives) upload(primitive);
///
/// Sources that run frames pay for these lines only. Sources that compile plans include plan.h, which has the scene.
#include "runtime/base/api.h"
#include "runtime/plan/frame_buffer.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_result.h"
#include "runtime/plan/vertex_source.h"

namespace sinew {

/// Runs one frame of a character. plan.h lists the errors. After an error the buffer still holds its last good frame.
SINEW_API ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept;

/// True if the buffer holds the result of this very input, so that run_plan would run no stage.
SINEW_API bool holds_result_of(const FrameBuffer& frame, const FrameInput& input) noexcept;

}  // namespace sinew
