// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/cut_pose.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"
#include "runtime/plan/reuse/reuse.h"

namespace sinew {

/// Evaluates one frame: runs the stages of the plan in their order. The result follows from plan and input alone; what
/// `reuse` says stands is left as it is, and has the bits that it would get.
/// in   input   checked;   memory  of a frame buffer of the plan;   past_caches  FrameBuffer::write_past_caches
/// out  result  views of the memory; all but `frame` and `since_frame`
/// cost the sum of the stages that run, no allocation. Internal to plan/
void evaluate_frame(const CompiledPlan& plan, const FrameInput& input, FrameMemory memory, const Reuse& reuse,
                    bool past_caches, FrameResult& result) noexcept;

/// The first half of a frame with a cut: the pose, in the frame's own memory, and its world matrices.
/// in   ops  operations of the program that run
/// out  pose     result.work  of this half
void evaluate_to_cut(const CompiledPlan& plan, const FrameInput& input, FrameMemory memory, const Reuse& reuse,
                     std::size_t ops, CutPose& pose, FrameResult& result) noexcept;

/// The second half, from the pose in the frame's own memory.
/// in   ops  as before
void evaluate_from_cut(const CompiledPlan& plan, const FrameInput& input, FrameMemory memory, const Reuse& reuse,
                       std::size_t ops, bool past_caches, FrameResult& result) noexcept;

}  // namespace sinew
