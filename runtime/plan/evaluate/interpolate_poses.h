// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/evaluate/frame_step.h"

namespace sinew {

/// Evaluates the pose of a plan with frames between updates (Needs::in.between_updates). The poses of
/// FrameInput::layers and FrameInput::next_layers stay in the frame's memory, together with their layers. A frame with
/// the same layers samples nothing.
/// eq   rotations (1 - s) q0 + s q1 on the shorter arc, normalised; translations, scales, weights and properties
///      linear. At s = 0 the result has the bits of the pose of `layers`
/// in   input   checked
/// out  the pose, a view of the frame's memory; FrameLayout::pose has the weights and properties
/// cost O(J + W), plus an evaluation for each of the two poses that no earlier frame holds; no allocation. Internal to
///      plan/
PoseSpan interpolate_poses(const CompiledPlan& plan, const FrameInput& input, const FrameStep& step,
                           FrameWork& work) noexcept;

}  // namespace sinew
