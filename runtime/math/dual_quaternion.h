// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"
#include "runtime/math/matrix_rotation.h"

namespace sinew {

/// A dual quaternion r + e d. For a rigid motion r is the unit rotation and d = t r / 2 (Kavan et al. 2008).
template <class T>
struct DualQuatT {
  Quat<T> real{T(1), T(0), T(0), T(0)};  // w x y z
  Quat<T> dual{T(0), T(0), T(0), T(0)};
};

using DualQuat = DualQuatT<float>;
using DualQuatd = DualQuatT<double>;

/// Dual quaternion of a rotation and a translation.
/// eq   r + e (t r) / 2, t as the pure quaternion (t, 0): rotate first, then translate
template <class T>
DualQuatT<T> dual_quat_from(const Quat<T>& rotation, const Vec3<T>& translation) noexcept {
  return {rotation, quat_xyzw(translation.x, translation.y, translation.z, T(0)) * rotation * T(0.5)};
}

/// Product of two motions.
/// eq   (a + e b)(c + e d) = a c + e (a d + b c): the right factor is applied first
template <class T>
DualQuatT<T> operator*(const DualQuatT<T>& a, const DualQuatT<T>& b) noexcept {
  return {a.real * b.real, a.real * b.dual + a.dual * b.real};
}

/// Inverse motion of a unit dual quaternion.
/// eq   r* + e d*
template <class T>
DualQuatT<T> dual_quat_conjugate(const DualQuatT<T>& q) noexcept {
  return {quat_conjugate(q.real), quat_conjugate(q.dual)};
}

/// Unit dual quaternion: real part of length 1, dual part perpendicular to it. If the real part is zero or not finite,
/// it is the identity.
/// eq   r' = r / |r|;  d' = d / |r| - r' (r' . d / |r|)   (Kavan et al. 2008, eq. 4)
template <class T>
DualQuatT<T> normalised(const DualQuatT<T>& q) noexcept {
  const T length = safe_length(q.real);
  if (!(length > T(0)) || !std::isfinite(length)) return {};
  const Quat<T> real = q.real / length, dual = q.dual / length;
  return {real, dual - real * quat_dot(real, dual)};
}

/// Translation of a unit dual quaternion.
/// eq   t = 2 vec(d r*) = 2 (r.w d.v - d.w r.v + r.v x d.v)   for unit r; a component of d along r cancels
template <class T>
Vec3<T> translation_of(const DualQuatT<T>& q) noexcept {
  const Vec3<T> r(q.real.x, q.real.y, q.real.z), d(q.dual.x, q.dual.y, q.dual.z);
  return (d * q.real.w - r * q.dual.w + glm::cross(r, d)) * T(2);
}

/// Rigid motion of a point by a unit dual quaternion.
template <class T>
Vec3<T> transform_point(const DualQuatT<T>& q, const Vec3<T>& p) noexcept {
  return rotate_vector(q.real, p) + translation_of(q);
}

template <class T>
Vec3<T> transform_vector(const DualQuatT<T>& q, const Vec3<T>& v) noexcept {
  return rotate_vector(q.real, v);
}

/// Matrix of a unit dual quaternion.
template <class T>
AffineT<T> affine_from_dual_quat(const DualQuatT<T>& q) noexcept {
  return affine_from(matrix_from_unit_quat(q.real), translation_of(q));
}

}  // namespace sinew
