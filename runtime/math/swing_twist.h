// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/quaternion.h"

namespace sinew {

/// Decomposition of a rotation by an axis: first a *twist* about the axis, then a *swing* that moves the axis to its
/// new direction.
/// eq   q = swing * twist   (Grassia 1998, "Practical parameterization of rotations using the exponential map", 6.3)

/// Sine and cosine of half the twist, both times the same nonzero number of either sign.
template <class T>
struct HalfTwistT {
  T sine = T(0), cosine = T(1);
};

/// The half twist of a rotation about an axis.
/// eq   (v . a, w) for q = (v, w).  A half turn that reverses the axis has no defined twist: it counts as no twist.
template <class T>
HalfTwistT<T> half_twist(const Quat<T>& q, const Vec3<T>& unit_axis) noexcept {
  const T sine = (q.x * unit_axis.x + q.y * unit_axis.y) + q.z * unit_axis.z;
  return sine == T(0) && q.w == T(0) ? HalfTwistT<T>{} : HalfTwistT<T>{sine, q.w};
}

/// Angle in [0, pi] between the twists of q and r, signs ignored. Exactly 0 for q and q, and for q and -q.
/// eq   2 atan2(|s_r c_q - c_r s_q|, |c_q c_r + s_q s_r|)   (acos would lose digits)
template <class T>
T twist_angle_between(const Quat<T>& q, const Quat<T>& r, const Vec3<T>& unit_axis) noexcept {
  const HalfTwistT<T> a = half_twist(q, unit_axis), b = half_twist(r, unit_axis);
  return T(2) *
         std::atan2(std::abs(a.cosine * b.sine - a.sine * b.cosine), std::abs(a.cosine * b.cosine + a.sine * b.sine));
}

/// Angle in [0, pi] between the directions to which unit q and r swing the axis.
/// eq   atan2(|a x b|, a . b)
template <class T>
T swing_angle_between(const Quat<T>& q, const Quat<T>& r, const Vec3<T>& unit_axis) noexcept {
  const Vec3<T> a = rotate_vector(q, unit_axis), b = rotate_vector(r, unit_axis);
  return std::atan2(safe_length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace sinew
