// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/make_palettes.h"

namespace sinew {

/// Stages sample to interpolate of a plan that knows frames between updates: local pose, morph weights and properties
/// of one frame. The poses of FrameInput::layers and of FrameInput::next_layers stay in the frame's memory with the
/// layers that gave them: where these are the same again, there or in the frame before, nothing is sampled. eq
/// rotations (1 - s) q0 + s q1 on the shorter arc, made unit; translations, scales, weights and properties linear. At s
/// = 0
///      the bits of evaluate_pose
/// in   input   checked
/// out  pose    view of the frame's memory; the plan's weights and properties are filled in the frame's memory
/// cost O(J + W) and what evaluate_pose costs for each end that is not there; no allocation
PoseSpan interpolate_poses(const Plan& plan, const FrameInput& input, const FrameStep& step, FrameWork& work) noexcept;

}  // namespace sinew
