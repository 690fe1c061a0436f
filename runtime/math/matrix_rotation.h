// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/quaternion.h"

namespace sinew {

/// Rotation matrix of a unit quaternion.
/// eq   Real-Time Rendering, eq. 4.46
template <class T>
Mat3<T> matrix_from_unit_quat(const Quat<T>& q) noexcept {
  const T xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const T xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const T wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  const Vec3<T> x(T(1) - T(2) * (yy + zz), T(2) * (xy + wz), T(2) * (xz - wy));
  const Vec3<T> y(T(2) * (xy - wz), T(1) - T(2) * (xx + zz), T(2) * (yz + wx));
  const Vec3<T> z(T(2) * (xz + wy), T(2) * (yz - wx), T(1) - T(2) * (xx + yy));
  return {x, y, z};
}

/// Rotation matrix of a quaternion of any finite length; the identity for length zero.
/// eq   Real-Time Rendering, eq. 4.45; the length enters only as s = 2 / |q|^2, so the rounding of a normalisation is
///      saved
template <class T>
Mat3<T> matrix_from_quat(const Quat<T>& any) noexcept {
  const Quat<T> q = is_safe_square(square_of(any)) ? any : normalised(any);
  const T s = T(2) / square_of(q);
  const Quat<T> p = q * s;
  const T xx = q.x * p.x, yy = q.y * p.y, zz = q.z * p.z;
  const T xy = q.x * p.y, xz = q.x * p.z, yz = q.y * p.z;
  const T wx = q.w * p.x, wy = q.w * p.y, wz = q.w * p.z;
  const Vec3<T> x(T(1) - (yy + zz), xy + wz, xz - wy);
  const Vec3<T> y(xy - wz, T(1) - (xx + zz), yz + wx);
  const Vec3<T> z(xz + wy, yz - wx, T(1) - (xx + yy));
  return {x, y, z};
}

/// Unit quaternion of a rotation matrix.
/// eq   Real-Time Rendering, eqs. 4.47-4.51; of the four forms the one with the largest divisor (at least 1), so half
///      turns lose no digits
/// in   m  orthonormal with positive determinant up to rounding: remove scale and mirroring first (decompose.h).
///      An error d of the matrix gives an error of at most about 4 d of the quaternion. The zero matrix gives the
///      identity.
template <class T>
Quat<T> quat_from_matrix(const Mat3<T>& m) noexcept {
  const T xx = m[0][0], yy = m[1][1], zz = m[2][2];
  const T x_of = m[1][2] - m[2][1], y_of = m[2][0] - m[0][2], z_of = m[0][1] - m[1][0];
  const T xy = m[0][1] + m[1][0], xz = m[0][2] + m[2][0], yz = m[1][2] + m[2][1];
  const T trace = xx + yy + zz;
  if (trace >= xx && trace >= yy && trace >= zz) return normalised(quat_xyzw(x_of, y_of, z_of, T(1) + trace));
  if (xx >= yy && xx >= zz) return normalised(quat_xyzw(T(1) + (xx - yy - zz), xy, xz, x_of));
  if (yy >= zz) return normalised(quat_xyzw(xy, T(1) + (yy - xx - zz), yz, y_of));
  return normalised(quat_xyzw(xz, yz, T(1) + (zz - xx - yy), z_of));
}

}  // namespace sinew
