// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/math/quaternion.h"

namespace sinew {

/// How far a joint may turn: an elliptic cone for the direction of its bone, and an interval for the twist about the
/// bone.
struct JointLimit {
  glm::quat center{1.0f, 0.0f, 0.0f, 0.0f};  ///< w x y z; unit. Local rotation at the center of the cone.

  /// Axes of the limit in the space of the joint: x is the bone, the axis of the twist. w x y z; unit.
  glm::quat axes{1.0f, 0.0f, 0.0f, 0.0f};
  float swing_y_rad = 0.0f, swing_z_rad = 0.0f;         ///< largest swing about the axes y and z; [0, 2.8]
  float least_twist_rad = 0.0f, most_twist_rad = 0.0f;  ///< about x, within [-pi, pi]
  bool limits_swing = true;                             ///< false: every swing is allowed
  bool limits_twist = true;                             ///< false: every twist is allowed

  friend bool operator==(const JointLimit&, const JointLimit&) = default;
};

/// Upper bounds for the angles of a limit. Within these bounds the projection is continuous over all rotations.
inline constexpr float kMostSwing_rad = 2.8f;
inline constexpr float kMostTwistRange_rad = 6.0f;

struct LimitedRotation {
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  ///< w x y z
  bool is_limited = false;                  ///< false: the rotation was allowed and kept its bits
};

/// A limit prepared for use: numbers that are computed once.
class JointLimiter {
 public:
  SINEW_API explicit JointLimiter(const JointLimit& limit) noexcept;

  /// The nearest allowed rotation to a local rotation.
  /// eq   q = center axes (swing twist) axes^-1; the swing is a rotation vector in the plane of y and z. A swing
  ///      outside the ellipse goes to the nearest point of the ellipse, a twist outside the interval to its nearest
  ///      end.
  ///      Such a rule jumps where the nearest point changes sides, at half a turn from the center. So swings close to
  ///      pi fade to the center, and the middle half of the forbidden twists moves from one end of the interval to the
  ///      other.
  /// in   rotation  unit
  /// cost about 300 ns if it limits, no allocation
  SINEW_API LimitedRotation operator()(const glm::dquat& rotation) const noexcept;

 private:
  glm::dquat from_;  ///< (center axes)^-1
  glm::dquat to_;    ///< center axes
  glm::dquat axes_, axes_back_;
  double swing_y_, swing_z_, least_, most_;
  bool limits_swing_, limits_twist_;
};

/// err  not_finite, not_normalised, too_large (a swing beyond its bounds, a twist interval longer than 6 or with
///      swapped ends)
SINEW_API ErrorCode check(const JointLimit& limit) noexcept;

}  // namespace sinew
