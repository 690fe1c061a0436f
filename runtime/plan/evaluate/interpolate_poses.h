// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/evaluate/frame_step.h"

namespace sinew {

/// evaluate_pose for a plan with frames between updates (Needs::in.between_updates). The poses of FrameInput::layers
/// and of FrameInput::next_layers stay in the frame's memory with the layers that gave them. Where the same layers come
/// again, nothing is sampled.
/// eq   rotations (1 - s) q0 + s q1 on the shorter arc, normalised; translations, scales, weights and properties
///      linear. At s = 0 the bits of evaluate_pose
/// in   input   checked
/// out  the pose, a view of the frame's memory; FrameLayout::pose has the weights and properties
/// cost O(J + W), and evaluate_pose for each of the two poses that no earlier frame has; no allocation. Internal to
///      plan/
PoseSpan interpolate_poses(const CompiledPlan& plan, const FrameInput& input, const FrameStep& step,
                           FrameWork& work) noexcept;

}  // namespace sinew
