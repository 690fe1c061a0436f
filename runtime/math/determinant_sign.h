// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"

namespace sinew {

/// Exact sign of the determinant: -1 where the matrix mirrors, 1 where it does not, 0 where it is singular.
/// eq   A determinant in double decides where it exceeds the bound of its rounding error. Else the six products of
///      three entries are summed without error (Shewchuk 1997, "Adaptive precision floating-point arithmetic", 4.3).
/// in   finite entries. Exact for every float matrix, and for matrices of doubles whose nonzero entries are at least
///      2^-300 of the largest entry of their column
/// out  the sign for the entries as given. A singular matrix whose entries were rounded before may have any sign.
/// cost about 25 operations where the error bound decides, else about 1000
int determinant_sign(const Mat3<float>& m) noexcept;
int determinant_sign(const Mat3<double>& m) noexcept;

/// As above, for the linear part.
template <class T>
int determinant_sign(const AffineT<T>& m) noexcept {
  return determinant_sign(linear_part(m));
}

}  // namespace sinew
