// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/evaluate/frame_work.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/pose_program/standing_operands.h"

namespace sinew {

/// How a frame's pose is made, and where.
struct PoseStep {
  std::span<const float> given_weights = {};  ///< [W] replace the clips' morph weights; empty = the clips' own
  FrameMemory memory = {};
  bool has_base = false;  ///< the memory has a pose of the one clip that plays: only its tracks are sampled
  std::size_t first = 0, end = kMostPoseOps;  ///< operations of a program to run, as in PoseProgramJob
  LastProgram last = {};                      ///< the last run into the memory
  std::span<KeptOperands> kept = {};          ///< FrameTables::kept
};

/// Stages sample, mirror, blend, add and properties: the local pose, morph weights and property values of one frame.
/// Layers are operations of a pose program: samples, their mean, and an addition for each layer that adds. A single
/// layer of full weight is sampled straight into the pose, so it has the bits of sample_clip.
/// in   layers  checked
/// out  the pose, a view of the frame's memory; FrameLayout::pose has the weights and properties
/// cost O(layers * tracks), no allocation. Internal to plan/
PoseSpan evaluate_layers(const CompiledPlan& plan, std::span<const ClipLayer> layers, const PoseStep& step,
                         FrameWork& work) noexcept;

/// As evaluate_layers, from the operations of a program, with stage pose_program.
/// in   input  checked; its program is not empty
/// out  the topmost pose, which is the frame's own at the end of the program
PoseSpan evaluate_program(const CompiledPlan& plan, const FrameInput& input, const PoseStep& step,
                          FrameWork& work) noexcept;

}  // namespace sinew
