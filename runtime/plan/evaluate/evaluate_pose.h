// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/evaluate/frame_work.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_memory.h"

namespace sinew {

/// Stages sample, mirror, blend, add and properties: the local pose, morph weights and property values of one frame. A
/// single layer of full weight is sampled straight into the pose, so it has the bits of sample_clip.
/// in   layers  checked;   given_weights[W]  replace the clips' morph weights; empty = the clips' own
///      has_base  the memory has a pose of the one clip that plays: only its tracks are sampled
/// out  the pose, a view of the frame's memory; FrameLayout::pose has the weights and properties
/// cost O(layers * tracks), no allocation. Internal to plan/
PoseSpan evaluate_pose(const CompiledPlan& plan, std::span<const ClipLayer> layers,
                       std::span<const float> given_weights, FrameMemory memory, bool has_base,
                       FrameWork& work) noexcept;

}  // namespace sinew
