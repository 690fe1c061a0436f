// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/animation/bone_animation.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/retarget/twist_map.h"

namespace sinew {

/// Turns the twist joints of a retargeted pose. Each gets a share of the twist of its driver (hand, foot, upper arm or
/// thigh). The twist is relative to the rest pose.
/// eq   d = q d0^-1 for a twist joint beside its driver, d = d0^-1 q for one below it; q is the driver's rotation, d0
///      its rest rotation. a is the twist angle of d about the bone (runtime/math/swing_twist.h), in (-pi, pi]: it
///      jumps when the twist passes a half turn. rotation = (cos(s a / 2), axis sin(s a / 2)) rest, s is the share
/// in   pose  local transforms of the target
/// out  pose  rotations of the twist joints are replaced
/// cost O(twist joints), some 50 ns each, no allocation
void share_twist(const TwistMap& twists, std::span<Transformd> pose) noexcept;

/// share_twist for the poses of frames. It also computes in double.
/// err  size_mismatch
struct ShareTwistJob {
  const TwistMap* twists = nullptr;
  PoseSpan pose;  ///< of the target, changed in place
};

ErrorCode check(const ShareTwistJob& job) noexcept;
void run_unchecked(const ShareTwistJob& job) noexcept;

/// share_twist for a retargeted animation. A twist joint whose driver is animated gets rotation keys at the driver's
/// key times. Unless the driver's keys step, it also gets 60 keys a second between them.
/// in   animation   of the target
/// out  animation   rotation tracks of the twist joints are replaced
/// cost O(duration * twist joints), allocates
void share_twist(const TwistMap& twists, Animation& animation);

}  // namespace sinew
