// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/frame_changes.h"
#include "runtime/plan/frame_work.h"

namespace sinew {

/// Stages sample to interpolate of a plan with frames between updates: the local pose, morph weights and properties of
/// one frame. The poses of FrameInput::layers and of FrameInput::next_layers stay in the frame's memory with the layers
/// that gave them. Where the same layers come again, in this memory or that of the frame before, nothing is sampled.
/// eq   rotations (1 - s) q0 + s q1 on the shorter arc, normalised; translations, scales, weights and properties
///      linear. At s = 0 the bits of evaluate_pose
/// in   input   checked
/// out  pose    view of the frame's memory; the plan's weights and properties are filled in the frame's memory
/// cost O(J + W), and evaluate_pose for each of the two poses that is not there; no allocation. Internal to plan/
PoseSpan interpolate_poses(const CompiledPlan& plan, const FrameInput& input, const FrameStep& step,
                           FrameWork& work) noexcept;

}  // namespace sinew
