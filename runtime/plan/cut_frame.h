// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/plan/cut_pose.h"
#include "runtime/plan/run_plan.h"

namespace sinew {

/// Runs the first half of a frame: the pose and its world matrices. The caller then reads and changes `pose`, and calls
/// run_from_cut for the second half. Frames of other characters may run between the halves, on any threads.
/// in   input    as for run_plan; the plan needs Needs::in.cut
///      ops      operations of FrameInput::program that run in the first half, at least 1. The others run in the second
///      half, on the topmost pose as the caller left it. Layers run in the first half
/// out  pose     valid until run_from_cut, or the next run into this buffer, which drops the cut
/// err  those of run_plan, and not_in_needs (no cut), unsupported (the input is asleep, no operation before the cut)
/// cost of the stages up to local_to_model, no allocation. The pose is computed in each such frame, since the caller
///      may have changed it. Palettes are compared: where their bits stay the same, nothing is deformed
SINEW_API ErrorCode run_to_cut(const Plan& plan, const FrameInput& input, FrameBuffer& frame, CutPose& pose,
                               std::size_t ops = kMostPoseOps) noexcept;

/// Runs the second half: the remaining operations, then all stages after the pose. `frame.result()` is then complete,
/// and has the bits that one run with the changed pose would have.
/// in   input  the same as for run_to_cut
/// err  no_cut (run_to_cut was not called before with this plan), not_finite (the caller wrote NaN or infinity), and
///      those of the input. After an error the frame buffer keeps its cut, so the call can be made again
SINEW_API ErrorCode run_from_cut(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept;

}  // namespace sinew
