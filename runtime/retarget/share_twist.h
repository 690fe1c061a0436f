// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/animation/bone_animation.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/retarget/twist_map.h"

namespace sinew {

/// Turns twist joints of a retargeted pose by their share of what a hand, a foot, an upper arm or a thigh is twisted
/// from its rest pose.
/// eq   d = q d0^-1 beside the driver, d0^-1 q below it, with q the driver's rotation and d0 its rest; a = the angle of
///      d's twist about the bone (runtime/math/swing_twist.h), in (-pi, pi]: it jumps where d is a half turn;
///      rotation = (cos(s a / 2), axis sin(s a / 2)) rest, s the share
/// in   pose  local transforms of the target
/// out  pose  rotations of the twist joints, in place
/// cost O(twist joints), some 50 ns each, no allocation
void share_twist(const TwistMap& twists, std::span<Transformd> pose) noexcept;

/// The same for poses of frames, also in double.
/// err  size_mismatch
struct ShareTwistJob {
  const TwistMap* twists = nullptr;
  PoseSpan pose;  ///< of the target, in place
};

ErrorCode check(const ShareTwistJob& job) noexcept;
void run_unchecked(const ShareTwistJob& job) noexcept;

/// The same for a retargeted animation: twist joints whose driver moves get rotation keys at its key times and, unless
/// those step, 60 times a second between them.
/// in   animation   of the target
/// out  animation   rotations of the twist joints, in place of those they had
/// cost O(duration * twist joints), allocates
void share_twist(const TwistMap& twists, Animation& animation);

}  // namespace sinew
