// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"
#include "runtime/plan/frame_result.h"
#include "runtime/plan/frame_work.h"
#include "runtime/pose/blend_poses.h"

namespace sinew {

/// Stages sample, blend and properties: the local pose, morph weights and property values of one frame. A single layer
/// of full weight goes straight into the pose: the bits are those of sample_clip. in   holds_clip     the memory has
/// the pose of a frame that the same clip made up alone, as it does this one
///      input          checked;   layers[max_layers]  room for the blend's table
/// out  pose           view of the frame's memory; the plan's weights and properties are filled in the frame's memory
/// cost O(layers * tracks), no allocation
PoseSpan evaluate_pose(const Plan& plan, const FrameInput& input, FrameMemory memory, std::span<BlendLayer> layers,
                       bool holds_clip, FrameWork& work) noexcept;

}  // namespace sinew
