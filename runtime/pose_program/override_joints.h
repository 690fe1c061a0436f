// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/math/affine.h"
#include "runtime/pose_program/run_pose_program.h"

namespace sinew {

/// Sets joints to the transforms of the caller, in the order given: a parent before its children. A transform in model
/// or world space is made local with the current transforms of the parents. A joint stays as it is if its parent's
/// matrix or the root is singular.
/// in   share  [0, 1] of the given transform in a mix with the pose; at 1 a local transform keeps its bits
///      root   world transform above all root joints
/// out  pose   in place.     cost O(depth) for each joint in model or world space.     Internal to pose_program/
void override_joints(const Skeleton& skeleton, std::span<const JointOverride> joints, float share, const Affine& root,
                     const PoseSpan& pose) noexcept;

}  // namespace sinew
