// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_buffer.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// Runs the stages of the plan for one character. Afterwards `frame.result()` holds the outcome. Parts that have not
/// changed since the frame before are not computed again. The same input runs no stage, and unchanged palettes and
/// weights deform nothing. Hidden meshes are not deformed, and a character that sleeps does no work.
/// in   frame  made for this plan: a plan that was compiled anew needs a new buffer
/// err  no_plan             a default plan
///      wrong_plan          the buffer, or the one given to FrameBuffer::follow, was made for another plan
///      moved_from          the buffer, or the one given to FrameBuffer::follow, was moved from
///      size_mismatch       `weights`, `out_of_view` or `geometry` is neither empty nor of the length that it needs
///      too_many_layers     more layers with a weight blend than Needs::in.max_layers
///      index_out_of_range  a clip that the plan does not know, a mask, a source without vertices for its instance
///      wrong_page          the page of a layer is cut from a clip with other joints, weights or properties
///      not_in_needs        an additive or mirrored layer, a weight below 1 without blending, a frame between updates,
///                          or more of a program and its inputs, where the needs do not declare it
///      not_finite          a time, a weight or the root is NaN or infinite
///      negative_weight     of a layer
///      not_a_fraction      the interpolation factor, or the weight of a source, is outside [0, 1]
///      too_large           a weight, or a number of the root, is above 1e9
///      two_times           one source is asked for two times in one frame
///      unsupported         a source in scene space for an instance with copies; layers or an interpolation factor
///                          beside a program; a procedure without code
///      The rules of programs are those of find_fault (pose_program.h).
///      After an error the frame buffer still holds its last good frame.
/// cost the sum of the plan's stages, no allocation; the same input gives the same bits, whatever ran before
SINEW_API ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept;

/// Says why run_plan refuses this call: which field, which index, which rule ("layers[1].weight: a weight is below 0").
/// Ask before the run if the buffer follows another one: a refused run forgets which buffer it should have followed.
/// out  empty where run_plan does not refuse     cost as the checks of run_plan, allocates the text
SINEW_API std::string why_refused(const Plan& plan, const FrameInput& input, const FrameBuffer& frame);

/// True if the buffer holds the result of this very input, so that run_plan would run no stage.
/// cost O(layers + weights + instances), no allocation
SINEW_API bool holds_result_of(const FrameBuffer& frame, const FrameInput& input) noexcept;

}  // namespace sinew
