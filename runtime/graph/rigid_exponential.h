// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "runtime/math/dual_quaternion.h"

namespace sinew {

/// A rigid motion as a constant velocity over unit time: rotation by `turn` (axis times radians) while moving along
/// `shift` in its own space.
struct RigidTwist {
  Vec3<double> turn{0.0}, shift{0.0};
};

/// Coefficients of the exponential for a turn by `angle`: b = (1 - cos a) / a^2, c = (a - sin a) / a^3.
struct TurnFactors {
  double b, c;

  explicit TurnFactors(double angle) noexcept {
    const double a2 = angle * angle;
    if (angle < 1e-2) {  // the next terms are below 1e-15
      b = 0.5 - a2 / 24.0 + a2 * a2 / 720.0;
      c = 1.0 / 6.0 - a2 / 120.0 + a2 * a2 / 5040.0;
    } else {
      b = (1.0 - std::cos(angle)) / a2;
      c = (angle - std::sin(angle)) / (a2 * angle);
    }
  }
};

/// eq   rotation exp(turn), translation V shift, V = I + b [turn] + c [turn]^2
inline DualQuatd exponential(const RigidTwist& twist) noexcept {
  const double angle = safe_length(twist.turn), half = 0.5 * angle;
  const double sinc = angle < 1e-6 ? 0.5 - angle * angle / 48.0 : std::sin(half) / angle;
  const TurnFactors f(angle);
  const Vec3<double> once = glm::cross(twist.turn, twist.shift), twice = glm::cross(twist.turn, once);
  return dual_quat_from(
      normalised(quat_xyzw(twist.turn.x * sinc, twist.turn.y * sinc, twist.turn.z * sinc, std::cos(half))),
      twist.shift + once * f.b + twice * f.c);
}

/// The twist whose exponential is this unit dual quaternion. Its turn is at most pi.
/// eq   shift = (I - [turn]/2 + k [turn]^2) t,  k = (1 - (a/2) cot(a/2)) / a^2
inline RigidTwist logarithm(const DualQuatd& motion) noexcept {
  const double sign = motion.real.w < 0.0 ? -1.0 : 1.0;
  const Vec3<double> v = Vec3<double>(motion.real.x, motion.real.y, motion.real.z) * sign;
  const double sine = safe_length(v), half = std::atan2(sine, motion.real.w * sign), angle = 2.0 * half;
  RigidTwist twist;
  twist.turn = v * (sine < 1e-9 ? 2.0 : angle / sine);
  const Vec3<double> t = translation_of(motion);
  const double a2 = angle * angle;
  const double k = angle < 1e-2 ? 1.0 / 12.0 + a2 / 720.0 : (1.0 - half * std::cos(half) / std::sin(half)) / a2;
  const Vec3<double> once = glm::cross(twist.turn, t), twice = glm::cross(twist.turn, once);
  twist.shift = t - once * 0.5 + twice * k;
  return twist;
}

}  // namespace sinew
