// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/animation/bone_animation.h"

namespace sinew {

/// The tracks of one joint in an animation; null where the joint keeps its rest value. Several of Animation::bones may
/// name the joint: if two of them have a track for the same property, the last one counts.
struct JointTracks {
  const Vec3Track* translation = nullptr;
  const QuatTrack* rotation = nullptr;
  const Vec3Track* scale = nullptr;
};

/// Tracks of a joint. They point into the animation.
/// cost O(animation.bones), no allocation
JointTracks tracks_of_joint(const Animation& animation, std::uint32_t joint) noexcept;

/// Tracks of each joint. They point into the animation.
/// in   joint_count  above every joint index in the animation
/// out  [joint_count]
/// cost O(animation.bones + joint_count), allocates
std::vector<JointTracks> tracks_by_joint(const Animation& animation, std::size_t joint_count);

/// The last entry of Animation::bones for a joint; its tracks override those of earlier entries. Appends an empty
/// entry if the joint has none.
/// cost O(animation.bones)
BoneAnimation& last_bone_of(Animation& animation, std::uint32_t joint);

}  // namespace sinew
