// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/bone_animation.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// A joint along an arm or leg bone that only turns about the bone. Twist joints spread the twist of the skin over the
/// length of the limb.
struct TwistJoint {
  std::uint32_t joint = 0, driver = 0;  ///< `driver` is the joint whose twist is shared
  bool is_below_driver = false;         ///< the driver is its parent; otherwise both have the same parent
  Vec3<double> axis{1, 0, 0};           ///< unit, along the bone, in the space of the joint's parent
  /// Share of the driver's twist. It grows from 0 at the elbow to 1 at the hand. Along an upper bone, which itself has
  /// the whole twist, it runs from -1 at the shoulder to 0 at the elbow.
  double share = 0.0;
  Quat<double> rest{1, 0, 0, 0}, driver_rest{1, 0, 0, 0};
};

/// Twist joints of a skeleton. Made once by make_twist_map; immutable.
struct TwistMap {
  std::vector<TwistJoint> joints;  ///< rising joint indices
};

/// Finds the twist joints of a humanoid that a skeleton map leaves at rest. A twist joint is a child of an upper or
/// lower arm or leg and lies along that bone. Its name contains the word `twist` or `roll`. Keys of twist joints are
/// rarely worth copying: most programs compute them, and rigs have different numbers of them. Joints that carry the
/// next bone (Rigify, Daz) are not twist joints: they rest, and the hand takes over the whole rotation.
/// in   map  to `target`
/// cost O(J log J), allocates
SINEW_API TwistMap make_twist_map(const SkeletonMap& map, const Skeleton& target);

/// Turns the twist joints of a retargeted pose. Each gets a share of the twist of its driver (hand, foot, upper arm or
/// thigh). The twist is relative to the reference pose of the map.
/// eq   d = q d0^-1 for a twist joint beside its driver, d = d0^-1 q for one below it; q is the driver's rotation, d0
///      its rotation in the reference pose. a is the twist angle of d about the bone (runtime/math/swing_twist.h), in
///      (-pi, pi]: it jumps when the twist passes a half turn. rotation = (cos(s a / 2), axis sin(s a / 2)) rest, s is
///      the share
/// in   pose  local transforms of the target
/// out  pose  rotations of the twist joints are replaced
/// cost O(twist joints), some 50 ns each, no allocation
SINEW_API void share_twist(const TwistMap& twists, std::span<Transformd> pose) noexcept;

/// share_twist for the poses of frames. It also computes in double.
/// err  size_mismatch
struct ShareTwistJob {
  const TwistMap* twists = nullptr;
  PoseSpan pose;  ///< pose of the target, changed in place
};

SINEW_API ErrorCode check(const ShareTwistJob& job) noexcept;
SINEW_API void run_unchecked(const ShareTwistJob& job) noexcept;

/// share_twist for a retargeted animation. A twist joint whose driver is animated gets rotation keys at the driver's
/// key times. Unless the driver's keys step, it also gets 60 keys a second between them.
/// in   animation   of the target
/// out  animation   rotation tracks of the twist joints are replaced
/// cost O(duration * twist joints), allocates
SINEW_API void share_twist(const TwistMap& twists, Animation& animation);

}  // namespace sinew
