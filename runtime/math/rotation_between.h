// SPDX-License-Identifier: MIT
#pragma once

#include "runtime/math/quaternion.h"

namespace sinew {

/// A unit vector perpendicular to unit u.
/// eq   normalise(u x e), e the coordinate axis with the largest angle to u, so the product never vanishes
template <class T>
Vec3<T> perpendicular_to(const Vec3<T>& u) noexcept {
  const Vec3<T> a(std::abs(u.x), std::abs(u.y), std::abs(u.z));
  const Vec3<T> axis = a.x <= a.y && a.x <= a.z ? Vec3<T>(1, 0, 0) : (a.y <= a.z ? Vec3<T>(0, 1, 0) : Vec3<T>(0, 0, 1));
  return normalised_or(glm::cross(u, axis), axis);
}

/// Shortest rotation that turns the direction of `from` (s) into that of `to` (t). For opposite vectors it is a half
/// turn about some axis perpendicular to s. If a vector has no direction it is the identity.
/// eq   q = (axis |s - t| / 2, |s + t| / 2) for unit s, t   (half-angle form of Real-Time Rendering, eqs. 4.56-4.58).
///      s - t and s + t are exact where they are small, so no digits cancel for parallel or opposite vectors.
///      The axis is s x t, made perpendicular to s - t. Then even an inaccurate axis turns s into t.
template <class T>
Quat<T> rotation_between(const Vec3<T>& from, const Vec3<T>& to) noexcept {
  const Vec3<T> none(T(0)), s = normalised_or(from, none), t = normalised_or(to, none);
  if (s == none || t == none) return quat_identity<T>();
  const Vec3<T> difference = s - t, sum = s + t;
  const T apart = safe_length(difference), together = safe_length(sum);
  if (apart == T(0)) return quat_identity<T>();
  const Vec3<T> along = difference / apart;
  const Vec3<T> unit = normalised_or(glm::cross(s, t), none), square = unit - along * glm::dot(unit, along);
  // For opposite vectors the cross product is rounding noise. It is replaced where it is mostly along s - t.
  const Vec3<T> axis = square_of(square) > T(0.25) ? normalised_or(square, none) : perpendicular_to(along);
  const Vec3<T> v = axis * apart;
  return normalised(quat_xyzw(v.x, v.y, v.z, together));
}

}  // namespace sinew
