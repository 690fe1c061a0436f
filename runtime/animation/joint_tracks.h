// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/animation/bone_animation.h"

namespace sinew {

/// What an animation says of one joint: its tracks, null where the joint rests. Where several of its `bones` name the
/// joint, tracks of all count, and of two for one property the last (G20).
struct JointTracks {
  const Vec3Track* translation = nullptr;
  const QuatTrack* rotation = nullptr;
  const Vec3Track* scale = nullptr;
};

/// Tracks of a joint. They point into the animation.
/// cost O(animation.bones), no allocation
JointTracks tracks_of_joint(const Animation& animation, std::uint32_t joint) noexcept;

/// Tracks of each joint. They point into the animation.
/// in   joint_count  greater than each joint that the animation names
/// out  [joint_count]
/// cost O(animation.bones + joint_count), allocates
std::vector<JointTracks> tracks_by_joint(const Animation& animation, std::size_t joint_count);

/// The last of an animation's bones that names a joint: a track put there is the one that counts. Where none does, an
/// empty one is appended.
/// cost O(animation.bones)
BoneAnimation& last_bone_of(Animation& animation, std::uint32_t joint);

}  // namespace sinew
