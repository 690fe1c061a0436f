// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/procedures/ik_result.h"
#include "runtime/procedures/joint_limit.h"
#include "runtime/procedures/pole.h"

namespace sinew {

/// A joint that takes a part of the turn towards the target.
struct AimJoint {
  std::uint32_t joint = 0;
  float share = 1.0f;           ///< >= 0: its part of the turn, relative to the sum of all shares
  std::uint32_t limit = kNone;  ///< index into AimGoal::limits
};

/// A target, and the joints that aim at it: eyes, a head on a neck and spine, a gun in a hand.
struct AimGoal {
  /// Each joint is below the previous one. The line that aims is fixed to the last joint.
  std::span<const AimJoint> joints;
  std::span<const JointLimit> limits = {};
  Vec3<double> target{0.0};  ///< in model space

  // In the space of the last joint: the line starts at `offset` and runs along `forward`. `up` is not parallel to it.
  Vec3<float> forward{0.0f, 0.0f, 1.0f}, up{0.0f, 1.0f, 0.0f}, offset{0.0f};

  Vec3<double> pole{0.0};       ///< direction in model space to which `up` turns; zero: the joints do not roll
  float twist_rad = 0.0f;       ///< additional roll about the line to the target
  float weight = 1.0f;          ///< [0, 1]; 0 keeps every bit of the pose
  float pole_fade = kPoleFade;  ///< [0, 1) as TwoBoneGoal::pole_fade
  float tolerance_rad = 1e-4f;  ///< angle in radians that counts as reached
};

/// Turns joints so that a line fixed to the last joint runs through a target.
/// eq   One joint: take the point o + s f of the line that is as far from the joint as the target g, |o + s f| = |g|.
///      The joint turns it to g by the shortest way, then rolls. If `up` points from the joint to that point, the roll
///      is arbitrary. This is solved in the space of the joint's parent, so parents may have any scale.
///      Several joints: from the first to the last, joint i takes share_i of the whole turn, and the last joint takes
///      the rest. The part of a turn that a limit forbids is left to the joints after it. Near half a turn a share goes
///      to 0 or 1, so that a head does not snap when the target passes behind it.
/// in   goal    finite; forward and up not zero and not parallel
/// out  local   rotations of the joints
///      result  may be null. radians_left is the angle between line and target, metres_left their distance. If the
///      target is nearer to the last joint than the whole line is, no turn reaches it.
/// err  size_mismatch, index_out_of_range (joints, limits), unsupported (no joint, not in one line, a fixed matrix,
///      forward and up without direction), not_finite, not_a_fraction (weight, fade), negative_weight (a share, the
///      tolerance), and those of the limits
/// cost O(joints * depth), no allocation
struct AimJob {
  const Skeleton* skeleton = nullptr;
  PoseSpan local;
  AimGoal goal;
  IkResult* result = nullptr;
};

SINEW_API ErrorCode check(const AimJob& job) noexcept;
SINEW_API void run_unchecked(const AimJob& job) noexcept;

}  // namespace sinew
