// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "runtime/math/affine.h"

namespace sinew {

/// Upper bound of the factor by which a matrix lengthens a vector; exact for rotations with uniform scale.
/// eq   sqrt(m + sqrt 2 s), m the mean and s the standard deviation of the eigenvalues of A^T A, from its trace and
///      Frobenius norm   (Wolkowicz and Styan 1980)
template <class T>
T largest_stretch(const AffineT<T>& a) noexcept {
  T trace = T(0), squares = T(0);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const T g = a.row[0][i] * a.row[0][k] + a.row[1][i] * a.row[1][k] + a.row[2][i] * a.row[2][k];
      squares += g * g;
      if (i == k) trace += g;
    }
  const T mean = trace / T(3), variance = squares / T(3) - mean * mean;
  return std::sqrt(mean + std::sqrt(T(2) * (variance > T(0) ? variance : T(0))));
}

}  // namespace sinew
