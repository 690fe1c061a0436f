// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/perpendicular.h"

namespace sinew {

/// Shortest rotation that turns the direction of s into that of t. For opposite vectors it is a half turn about some
/// axis perpendicular to s; for a vector without direction it is the identity.
/// eq   q = (axis |s - t| / 2, |s + t| / 2) for unit s, t   (half-angle form of Real-Time Rendering, eqs. 4.56-4.58):
///      both differences are exact where they are small, so neither end cancels (N14). The axis is s x t made
///      perpendicular to s - t: then even a poor axis turns s into t.
template <class T>
Quat<T> rotation_between(const Vec3<T>& from, const Vec3<T>& to) noexcept {
  const Vec3<T> none(T(0)), s = normalised_or(from, none), t = normalised_or(to, none);
  if (s == none || t == none) return quat_identity<T>();
  const Vec3<T> difference = s - t, sum = s + t;
  const T apart = safe_length(difference), together = safe_length(sum);
  if (apart == T(0)) return quat_identity<T>();
  const Vec3<T> along = difference / apart;
  const Vec3<T> unit = normalised_or(glm::cross(s, t), none), square = unit - along * glm::dot(unit, along);
  // Opposite vectors leave only noise in the product: an axis that is mostly along s - t is not used.
  const Vec3<T> axis = square_of(square) > T(0.25) ? normalised_or(square, none) : perpendicular_to(along);
  const Vec3<T> v = axis * apart;
  return normalised(quat_xyzw(v.x, v.y, v.z, together));
}

}  // namespace sinew
