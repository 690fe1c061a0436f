// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Weight of the upper pose in a mix, per joint. Internal to pose_program/.
struct MixShare {
  float weight = 1.0f;
  std::span<const float> joint_weights;  ///< [J] or empty

  float of(std::size_t joint) const noexcept {
    const float share = joint_weights.empty() ? weight : weight * joint_weights[joint];
    return share < 1.0f ? share : 1.0f;
  }
};

/// Mixes two local transforms.
/// eq   t = (1 - w) t_below + w t_above, s likewise; q = normalise((1 - w) q_below +- w q_above), the sign by
///      hemisphere.
///      At w = 0 the result has the bits of `below`, at w = 1 those of `above`.
Transform mixed(const Transform& below, const Transform& above, float w) noexcept;

/// Lays `above` over `below`, joint by joint in local space.
/// out  below  in place
void overlay_pose(const PoseSpan& above, const MixShare& share, const PoseSpan& below) noexcept;

/// As overlay_pose, but rotations are mixed in model space. Joints with share 0 below joints with a share keep their
/// local rotation of `below`. Joints with share 1 get the model rotation of `above`.
/// eq   G = slerp(G_below, G_above, w) along the short arc, G the rotation in model space; q = conj(G_parent) G
/// in   skeleton  parents before children;   rotations[3 J]  scratch
/// out  below  in place
void overlay_pose_in_model_space(const Skeleton& skeleton, const PoseSpan& above, const MixShare& share,
                                 std::span<glm::quat> rotations, const PoseSpan& below) noexcept;

}  // namespace sinew
