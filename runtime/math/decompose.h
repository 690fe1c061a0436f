// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/api.h"
#include "runtime/math/affine.h"
#include "runtime/math/transform.h"

namespace sinew {

/// Result of a decomposition. The returned parts are usable in every case.
enum class DecomposeStatus : std::uint8_t {
  ok,
  mirrored,    ///< negative determinant: decompose_polar makes S negative definite, decompose_trs makes scale.x < 0
  sheared,     ///< decompose_trs only: the columns are not perpendicular, so T * R * S differs from the matrix
  singular,    ///< rank below 3 within rounding: part of the rotation is arbitrary
  not_finite,  ///< NaN or infinite entries: the identity is returned
};

/// M = R S, with a rotation R (determinant +1) and a symmetric S. If M mirrors, S is negative definite (R = -U V^T).
/// If M has rank 2 or 3 within rounding, det S has exactly the sign of det M (determinant_sign.h). If det M = 0, det S
/// may be positive.
template <class T>
struct PolarT {
  Mat3<T> rotation{T(1)};
  Quat<T> quat{T(1), T(0), T(0), T(0)};                 ///< the same rotation, w x y z
  T stretch[6] = {T(1), T(1), T(1), T(0), T(0), T(0)};  ///< xx yy zz xy xz yz
  DecomposeStatus status = DecomposeStatus::ok;
};

/// Polar decomposition.
/// eq   M = U D V^T by one-sided Jacobi (Hestenes), after scaling by the largest entry; R = U V^T, S = V D V^T, for
///      det M < 0: R = -U V^T, S = -V D V^T (Shoemake and Duff 1992; no inverse is formed, so every rank works)
/// cost about 3 sweeps of 3 rotations, in double also for float matrices
template <class T>
PolarT<T> decompose_polar(const Mat3<T>& m) noexcept;

/// Symmetric matrix of a stretch as stored in PolarT.
template <class T>
Mat3<T> matrix_from_stretch(const T (&s)[6]) noexcept {
  return {s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2]};
}

template <class T>
struct TrsT {
  TransformT<T> transform;
  DecomposeStatus status = DecomposeStatus::ok;
};

/// Translation, rotation and scale of a matrix. The scale is the column lengths; scale.x is negative if the matrix
/// mirrors. If the matrix shears, `rotation` is the rotation nearest to the normalised columns. The status is the
/// worst that applies: singular, then sheared, then mirrored.
/// err  status   cost O(1), no allocation
template <class T>
TrsT<T> decompose_trs(const AffineT<T>& m) noexcept;

template <>
SINEW_API PolarT<float> decompose_polar(const Mat3<float>&) noexcept;
template <>
SINEW_API PolarT<double> decompose_polar(const Mat3<double>&) noexcept;
template <>
SINEW_API TrsT<float> decompose_trs(const AffineT<float>&) noexcept;
template <>
SINEW_API TrsT<double> decompose_trs(const AffineT<double>&) noexcept;

}  // namespace sinew
