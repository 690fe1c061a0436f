// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"
#include "runtime/plan/frame_work.h"
#include "runtime/pose/blend_poses.h"

namespace sinew {

/// Stages sample, blend, add and properties: the local pose, morph weights and property values of one frame. A single
/// layer of full weight is sampled straight into the pose: the bits are those of sample_clip.
/// in   layers         checked;   given_weights[W]  replace the clips' morph weights; empty = none are given
///      blend_layers[max_layers]  room for the blend's table
///      same_clip      the memory has the pose of a frame that the same clip made up alone, as it does this one
/// out  pose           view of the frame's memory; the plan's weights and properties are filled in the frame's memory
/// cost O(layers * tracks), no allocation. Internal to plan/
PoseSpan evaluate_pose(const CompiledPlan& plan, std::span<const ClipLayer> layers,
                       std::span<const float> given_weights, FrameMemory memory, std::span<BlendLayer> blend_layers,
                       bool same_clip, FrameWork& work) noexcept;

}  // namespace sinew
