// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/procedures/ik_result.h"
#include "runtime/procedures/pole.h"

namespace sinew {

/// Rotation of the last joint of a limb.
enum class EndRotation : std::uint8_t {
  follow,  ///< the tip turns with the bone before it
  keep,    ///< the tip keeps its rotation in model space
  given,   ///< the tip takes TwoBoneGoal::end_rotation in model space
};

/// The quantity that a weight below 1 mixes between input pose and solution.
enum class IkBlend : std::uint8_t {
  pose,      ///< rotations of the joints; beyond turns of 150 degrees the share goes to 0 or 1
  effector,  ///< place of the tip: it moves along a straight line towards the target
};

/// A limb and the target of its tip. Angles are in radians. Shares are fractions of the straight limb's length.
struct TwoBoneGoal {
  std::uint32_t root = 0, middle = 0, tip = 0;  ///< each below the previous one; joints in between do not turn
  Vec3<double> target{0.0};                     ///< where the tip shall be, in model space
  Vec3<double> pole{0.0};                       ///< direction or place towards which the middle joint bends (pole_kind)
  PoleKind pole_kind = PoleKind::none;
  IkBlend blend = IkBlend::pose;
  EndRotation end = EndRotation::follow;
  glm::quat end_rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< w x y z; unit

  /// Axis of the hinge in the space of the middle joint. The limb bends about it by positive angles. Zero: the axis
  /// about which the pose bends; for a straight pose, that of the rest pose.
  Vec3<float> middle_axis{0.0f};
  float twist_rad = 0.0f;     ///< turns the limb about the line from root to target
  float weight = 1.0f;        ///< [0, 1]; 0 keeps every bit of the pose
  float soft_reach = 0.0f;    ///< [0, 1) last share over which the limb straightens smoothly (kSoftReach); 0 = off
  float most_stretch = 1.0f;  ///< >= 1: factor by which bones may lengthen; 1 = off
  float least_bend_rad = 0.0f, most_bend_rad = 3.14159265f;  ///< [0, pi]; 0 = straight, pi = folded
  float pole_fade = kPoleFade;  ///< [0, 1) as kPoleFade; 0: no fade, so the limb snaps at the pole
  float tolerance = 1e-5f;      ///< distance from the target that counts as reached, as a share
};

/// Two-bone inverse kinematics on a local pose.
/// eq   All is solved in the space of the root joint's parent, so parents of any scale and place are exact.
///      The middle joint turns about its hinge until the tip is as far from the root as the target is. This is the
///      corner of a triangle (two_bones::corner), or a bisection if joints of the limb scale unevenly. Then the root
///      joint turns the tip to the target. Without a pole it takes the shortest way, which carries the bend plane
///      along. A pole turns that plane about the line to the target.
///      Degenerate input keeps the bend plane of the pose. A target at the root keeps the direction of the tip, a
///      folded limb opens to the side of its hinge, and a bone without length only follows.
/// in   goal    finite; the three joints lie on one path to the root of the skeleton
///      above   model matrix of the parent of goal.root; null: it is computed from `local`
/// out  local   rotations of root and middle joint, and of the tip unless it follows; translations if the limb
///              stretches
///      result  may be null
/// err  size_mismatch, index_out_of_range, unsupported (joints not in one line, a joint with a fixed matrix),
///      not_finite, not_a_fraction (weight, soft reach, fade), negative_weight (tolerance), too_large (bend limits,
///      stretch)
/// cost O(depth of the root joint), or O(1) with `above`; no allocation
struct TwoBoneIkJob {
  const Skeleton* skeleton = nullptr;
  PoseSpan local;
  TwoBoneGoal goal;
  const Affined* above = nullptr;
  IkResult* result = nullptr;
};

SINEW_API ErrorCode check(const TwoBoneIkJob& job) noexcept;
SINEW_API void run_unchecked(const TwoBoneIkJob& job) noexcept;

/// Many limbs, of any skeletons and poses, several at a time in the lanes of vector instructions.
/// in   limbs  none reads or writes a joint that another writes: two legs of one pose, but not an arm and a finger of it
/// out  as each job alone, bit for bit
/// err  as check of the first limb that is refused; then no limb is solved
struct TwoBoneIkLimbsJob {
  std::span<const TwoBoneIkJob> limbs;
};

SINEW_API ErrorCode check(const TwoBoneIkLimbsJob& job) noexcept;
SINEW_API void run_unchecked(const TwoBoneIkLimbsJob& job) noexcept;

}  // namespace sinew
