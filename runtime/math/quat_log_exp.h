// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/quaternion.h"

namespace sinew {

/// Logarithm of a rotation: phi u for q = (u sin phi, cos phi), phi in [0, pi].
/// eq   log q = v atan2(|v|, w) / |v|   (Real-Time Rendering, eq. 4.42). The sign of q counts: log(-1) = (pi, 0, 0).
///      v is scaled before it is normalised, so tiny rotations keep their relative accuracy.
template <class T>
Vec3<T> quat_log(const Quat<T>& q) noexcept {
  const Vec3<T> v(q.x, q.y, q.z);
  const T m = largest_component(v);
  if (!(m > T(0))) return q.w < T(0) ? Vec3<T>(std::atan2(T(0), q.w), T(0), T(0)) : Vec3<T>(T(0));
  const Vec3<T> s = v / m;
  const T length = std::sqrt(s.x * s.x + s.y * s.y + s.z * s.z);
  return s * (std::atan2(m * length, q.w) / length);
}

/// Rotation of a logarithm.
/// eq   exp(phi u) = (u sin phi, cos phi)   (Real-Time Rendering, eq. 4.41); exp(0) is the identity
template <class T>
Quat<T> quat_exp(const Vec3<T>& v) noexcept {
  const T m = largest_component(v);
  if (!(m > T(0))) return quat_identity<T>();
  const Vec3<T> s = v / m;
  const T length = std::sqrt(s.x * s.x + s.y * s.y + s.z * s.z);
  const T phi = m * length;
  const Vec3<T> u = s * (std::sin(phi) / length);
  return quat_xyzw(u.x, u.y, u.z, std::cos(phi));
}

/// Power of a rotation.
/// eq   q^t = exp(t log q)   (Real-Time Rendering, eq. 4.43), the sign of q counts: -q turns the long way round
template <class T>
Quat<T> quat_pow(const Quat<T>& q, T t) noexcept {
  return quat_exp(quat_log(q) * t);
}

}  // namespace sinew
