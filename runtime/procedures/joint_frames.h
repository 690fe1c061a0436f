// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/animation/skeleton.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Matrices and rotations of joints of a local pose in double precision. Internal to procedures/

/// A local transform of a pose, in double.
inline Transformd local_of(const PoseSpan& local, std::uint32_t joint) noexcept {
  const Transform t = local.get(joint);
  return {Vec3<double>(t.translation), quat_cast<double>(t.rotation), Vec3<double>(t.scale)};
}

/// Matrix of a joint in its parent's space. A fixed matrix of the skeleton takes precedence over the pose.
Affined local_matrix(const Skeleton& skeleton, const PoseSpan& local, std::uint32_t joint) noexcept;

/// Model matrix of a joint, or the identity for kNone.    cost O(depth)
Affined model_matrix(const Skeleton& skeleton, const PoseSpan& local, std::uint32_t joint) noexcept;

/// Product of the rotations of a joint and of all joints above it, without their scales and mirroring. The identity for
/// kNone.
Quat<double> model_rotation(const Skeleton& skeleton, const PoseSpan& local, std::uint32_t joint) noexcept;

/// Matrix from the space of `joint` to the space of `ancestor`. The transform of `ancestor` itself is not included.
Affined matrix_below(const Skeleton& skeleton, const PoseSpan& local, std::uint32_t ancestor,
                     std::uint32_t joint) noexcept;

/// True if `joint` is `ancestor` or below it.
inline bool is_below(const Skeleton& skeleton, std::uint32_t joint, std::uint32_t ancestor) noexcept {
  while (joint != kNone && joint > ancestor) joint = skeleton.parents[joint];
  return joint == ancestor;
}

/// True if a procedure may turn the joint: it has a rotation of its own instead of a fixed matrix.
inline bool can_turn(const Skeleton& skeleton, std::uint32_t joint) noexcept {
  return skeleton.fixed_matrix_of[joint] == kNone;
}

/// A share of the turn from one rotation to another, by slerp. Slerp jumps to the other side where the turn exceeds
/// half a turn. Close to half a turn the share goes to 0 or 1, whichever is nearer, so that the result does not snap.
Quat<double> part_of_turn(const Quat<double>& from, const Quat<double>& to, double share) noexcept;

/// Writes a rotation on the hemisphere of the current one, so that later blends take the short arc.
inline void write_rotation(const PoseSpan& local, std::uint32_t joint, const Quat<double>& rotation) noexcept {
  const Quat<double> now = quat_cast<double>(local.get(joint).rotation);
  local.set_rotation(joint, quat_cast<float>(normalised(aligned_with(now, rotation))));
}

}  // namespace sinew
