// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/quaternion.h"

namespace sinew {

template <class T>
struct AxisAngleT {
  Vec3<T> axis{T(1), T(0), T(0)};  ///< unit
  T angle_rad = T(0);              ///< [0, pi]
};

/// Unit quaternion of a rotation by an angle about an axis.
/// eq   q = (sin(angle / 2) axis, cos(angle / 2))   (Real-Time Rendering, eq. 4.39)
/// in   axis  any finite length (normalised here); an axis without direction gives the identity
template <class T>
Quat<T> quat_from_axis_angle(const Vec3<T>& axis, T angle_rad) noexcept {
  const Vec3<T> u = normalised_or(axis, Vec3<T>(T(0)));
  if (u == Vec3<T>(T(0))) return quat_identity<T>();
  const Vec3<T> v = u * std::sin(angle_rad / T(2));
  return quat_xyzw(v.x, v.y, v.z, std::cos(angle_rad / T(2)));
}

/// Matrix of a rotation by an angle about an axis.
/// eq   R = cos I + (1 - cos) u u^T + sin [u]x   (Goldman; Real-Time Rendering, eq. 4.30); for small angles 1 - cos
///      is 2 sin^2(angle / 2), which keeps its digits
template <class T>
Mat3<T> matrix_from_axis_angle(const Vec3<T>& axis, T angle_rad) noexcept {
  const Vec3<T> u = normalised_or(axis, Vec3<T>(T(0)));
  if (u == Vec3<T>(T(0))) return Mat3<T>(T(1));
  const T c = std::cos(angle_rad), s = std::sin(angle_rad), half = std::sin(angle_rad / T(2));
  const T k = c < T(0.5) ? T(1) - c : T(2) * half * half;
  const Vec3<T> ku = u * k, su = u * s;
  const Vec3<T> x(c + ku.x * u.x, ku.x * u.y + su.z, ku.x * u.z - su.y);
  const Vec3<T> y(ku.x * u.y - su.z, c + ku.y * u.y, ku.y * u.z + su.x);
  const Vec3<T> z(ku.x * u.z + su.y, ku.y * u.z - su.x, c + ku.z * u.z);
  return {x, y, z};
}

/// Axis and angle in [0, pi] of a rotation. The axis of the identity is x. The length of the vector part is computed
/// from its components, since 1 - w^2 would lose digits for small rotations.
/// eq   angle = 2 atan2(|v|, |w|), axis = v / |v|, negated when w < 0
template <class T>
AxisAngleT<T> axis_angle_from_quat(const Quat<T>& q) noexcept {
  const Vec3<T> v(q.x, q.y, q.z);
  const Vec3<T> axis = normalised_or(v, Vec3<T>(T(1), T(0), T(0)));
  return {q.w < T(0) ? -axis : axis, T(2) * std::atan2(safe_length(v), std::abs(q.w))};
}

}  // namespace sinew
