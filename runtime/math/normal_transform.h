// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <type_traits>

#include "runtime/math/determinant_sign.h"
#include "runtime/math/quaternion.h"

namespace sinew {

/// Cofactor matrix, the transpose of the adjugate. It needs no division, so it also exists for singular matrices.
/// eq   cof(M) = [c1 x c2, c2 x c0, c0 x c1], c the columns of M;  cof(M)(a x b) = M a x M b   (Real-Time Rendering,
///      4.1.7)
template <class T>
Mat3<T> cofactor(const Mat3<T>& m) noexcept {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

/// Entry of largest absolute value; NaN entries count as 0.
template <class T>
T largest_entry(const Mat3<T>& m) noexcept {
  return (std::max)((std::max)(largest_component(m[0]), largest_component(m[1])), largest_component(m[2]));
}

/// Cofactor matrix of M divided by its largest entry: transforms normals to the same directions, without overflow or
/// underflow.
template <class T>
Mat3<T> normal_matrix(const Mat3<T>& m) noexcept {
  const T scale = largest_entry(m);
  if (!(scale > T(0)) || !std::isfinite(scale)) return Mat3<T>(T(0));
  Mat3<T> s = m;
  for (int c = 0; c < 3; ++c) s[c] /= scale;
  return cofactor(s);
}

/// Unit normal of a surface that was moved by M. It points to the side that the winding gives: that of the cross
/// product of two moved edges. If M leaves no normal (rank below 2), the result is n.
/// eq   normalise(cof(M) n)
template <class T>
Vec3<T> transform_normal(const Mat3<T>& m, const Vec3<T>& n) noexcept {
  return normalised_or(normal_matrix(m) * n, n);
}

/// As transform_normal, but it points to the outside of a solid also when M mirrors (conventions.h).
/// eq   normalise(sign(det M) cof(M) n): the direction of the inverse transpose where that exists. The sign is exact
///      (determinant_sign.h); a singular M counts as not mirroring. For float matrices the rest is computed in double,
///      where products of two entries are exact and nothing overflows. So the normal is accurate for any condition
///      number.
template <class T>
Vec3<T> transform_normal_outward(const Mat3<T>& m, const Vec3<T>& n) noexcept {
  const Mat3<double> exact(m);
  const Mat3<double> cof = std::is_same_v<T, float> ? cofactor(exact) : normal_matrix(exact);
  const Vec3<double> moved = cof * Vec3<double>(n);
  return Vec3<T>(normalised_or(determinant_sign(m) < 0 ? -moved : moved, Vec3<double>(n)));
}

}  // namespace sinew
