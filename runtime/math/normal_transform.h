// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <limits>

#include "runtime/math/affine.h"
#include "runtime/math/quaternion.h"

namespace sinew {

/// Cofactor matrix: transpose of the adjoint. Exists for every matrix, singular ones too, without a division.
/// eq   cof(M) = [c1 x c2, c2 x c0, c0 x c1], c the columns of M;  cof(M)(a x b) = M a x M b   (Real-Time Rendering,
///      4.1.7)
template <class T>
Mat3<T> cofactor(const Mat3<T>& m) noexcept {
  return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

/// Entry of largest absolute value; NaN entries count as 0.
template <class T>
T largest_entry(const Mat3<T>& m) noexcept {
  return std::max(std::max(largest_component(m[0]), largest_component(m[1])), largest_component(m[2]));
}

/// Cofactor matrix of M divided by its largest entry: the same directions, without overflow or underflow (N22).
template <class T>
Mat3<T> normal_matrix(const Mat3<T>& m) noexcept {
  const T scale = largest_entry(m);
  if (!(scale > T(0)) || !std::isfinite(scale)) return Mat3<T>(T(0));
  Mat3<T> s = m;
  for (int c = 0; c < 3; ++c) s[c] /= scale;
  return cofactor(s);
}

/// Normal of a surface that was moved by M, unit length, on the side that follows the winding: the cross product of two
/// moved edges. Where M leaves no normal (rank below 2) the normal stays as it was.
/// eq   normalise(cof(M) n)
template <class T>
Vec3<T> transform_normal(const Mat3<T>& m, const Vec3<T>& n) noexcept {
  return normalised_or(normal_matrix(m) * n, n);
}

/// A determinant below this, of a matrix of Frobenius norm 1, is what rounding leaves of a flat one.
template <class T>
inline constexpr T kFlatDeterminant = T(4) * std::numeric_limits<T>::epsilon();

/// As transform_normal, but pointing to the outside of a solid also when M mirrors (conventions.h; hard case G48).
/// eq   normalise(sign(det M) cof(M) n): the direction of the inverse transpose wherever that exists; a flat M counts
/// as
///      not mirroring, whatever sign rounding gave its determinant
template <class T>
Vec3<T> transform_normal_outward(const Mat3<T>& m, const Vec3<T>& n) noexcept {
  const T scale = largest_entry(m);
  const Mat3<T> cof = normal_matrix(m);
  if (!(scale > T(0))) return normalised_or(cof * n, n);
  const Mat3<T> s{m[0] / scale, m[1] / scale, m[2] / scale};
  const T squares = glm::dot(s[0], s[0]) + glm::dot(s[1], s[1]) + glm::dot(s[2], s[2]);
  const bool mirrors = glm::dot(s[0], cof[0]) < -kFlatDeterminant<T> * squares * std::sqrt(squares);
  return normalised_or(mirrors ? -(cof * n) : cof * n, n);
}

}  // namespace sinew
