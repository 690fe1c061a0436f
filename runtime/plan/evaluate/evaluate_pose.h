// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/evaluate/frame_work.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/reuse/reuse.h"

namespace sinew {

/// Settings for the evaluation of a frame's pose.
struct PoseStep {
  const PoseProgramInputs& inputs;            ///< FrameInput::program_inputs
  const Affine& root;                         ///< FrameInput::root
  std::span<const float> given_weights = {};  ///< [W] replace the clips' morph weights; empty = the clips' own
  FrameMemory memory = {};
  bool has_base = false;  ///< the memory holds a pose of the only clip that plays, so only its tracks are sampled
  std::size_t first = 0, end = kMostPoseOps;  ///< operations of a program to run, as in PoseProgramJob
};

/// Runs the stages sample, mirror, blend, add and properties: the local pose, morph weights and property values of a
/// frame. Layers become operations of a pose program: samples, their mean, and an addition for each additive layer. A
/// single layer of full weight is sampled directly into the pose, so it has the bits of sample_clip.
/// in   layers  checked
/// out  the pose, a view of the frame's memory; FrameLayout::pose has the weights and properties
/// cost O(layers * tracks), no allocation. Internal to plan/
PoseSpan evaluate_layers(const CompiledPlan& plan, std::span<const ClipLayer> layers, const PoseStep& step,
                         FrameWork& work) noexcept;

/// Same, but the caller's pose program makes the pose (stage pose_program).
/// in   input  checked; its program is not empty;   reuse  of the frame's memory
/// out  the topmost pose of the stack, which is the frame's own pose at the end of the program
PoseSpan evaluate_program(const CompiledPlan& plan, const FrameInput& input, const PoseStep& step, const Reuse& reuse,
                          FrameWork& work) noexcept;

}  // namespace sinew
