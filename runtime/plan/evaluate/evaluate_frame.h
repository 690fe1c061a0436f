// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/cut_pose.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"
#include "runtime/plan/reuse/reuse.h"

namespace sinew {

/// Evaluates one frame: runs the stages of the plan in their order. The result depends on plan and input alone. Parts
/// that `reuse` finds still valid are left as they are, since they already have the bits that they would get.
/// in   input   checked;   memory  of a frame buffer of the plan;   past_caches  FrameBuffer::write_past_caches
/// out  result  views of the memory; all fields but `frame` and `since_frame` are set
/// cost the sum of the stages that run, no allocation. Internal to plan/
void evaluate_frame(const CompiledPlan& plan, const FrameInput& input, FrameMemory memory, const Reuse& reuse,
                    bool past_caches, FrameResult& result) noexcept;

/// The first half of a frame in which the caller changes the pose (a cut): the pose, in the frame's own memory, and its
/// world matrices.
/// in   ops  number of operations of the pose program to run
/// out  pose     result.work  counters of this half
void evaluate_to_cut(const CompiledPlan& plan, const FrameInput& input, FrameMemory memory, const Reuse& reuse,
                     std::size_t ops, CutPose& pose, FrameResult& result) noexcept;

/// The second half: runs all stages after the pose, which the frame's own memory holds.
/// in   ops  as in evaluate_to_cut
void evaluate_from_cut(const CompiledPlan& plan, const FrameInput& input, FrameMemory memory, const Reuse& reuse,
                       std::size_t ops, bool past_caches, FrameResult& result) noexcept;

}  // namespace sinew
