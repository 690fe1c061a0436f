// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/plan/cut_pose.h"
#include "runtime/plan/run_plan.h"

namespace sinew {

/// Runs the first half of a frame: the pose and its world matrices. The caller looks, writes into `pose`, and calls
/// run_from_cut for the rest. Frames of other characters may run between the halves, on any threads.
/// in   input    as for run_plan; the plan needs Needs::in.cut
///      ops      [1, ...] operations of FrameInput::program that run before the cut; the others run after it, on the
///               topmost pose as the caller left it. Layers run before it as a whole
/// out  pose     valid until run_from_cut, or the next run into this buffer, which drops the cut
/// err  those of run_plan, and not_in_needs (no cut), unsupported (the input is asleep, no operation before the cut)
/// cost of the stages up to local_to_model, no allocation. Poses are made anew in each such frame, since nobody knows
///      what the caller wrote. Palettes are compared: where their bits stay, nothing is deformed
SINEW_API ErrorCode run_to_cut(const Plan& plan, const FrameInput& input, FrameBuffer& frame, CutPose& pose,
                               std::size_t ops = kMostPoseOps) noexcept;

/// Runs the second half: the other operations, then all stages that follow a pose. `frame.result()` is whole
/// afterwards, and has the bits that one run with the written pose would have.
/// in   input  the same as for run_to_cut
/// err  no_cut (run_to_cut was not called before with this plan), not_finite (the caller wrote NaN or infinity), and those of the input.
///      The frame buffer keeps its cut then
SINEW_API ErrorCode run_from_cut(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept;

}  // namespace sinew
