// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/conventions.h"

namespace sinew {

/// The six basic shears; the first letter is the coordinate that changes, the second the one that does the shearing.
enum class Shear { xy, xz, yx, yz, zx, zy };

/// eq   H_ij(s): p_i' = p_i + s p_j   (Real-Time Rendering, eq. 4.15). The inverse is H_ij(-s), the determinant 1.
template <class T>
Mat3<T> shearing(Shear kind, T s) noexcept {
  constexpr int kChanged[] = {0, 0, 1, 1, 2, 2}, kShearing[] = {1, 2, 0, 2, 0, 1};
  Mat3<T> m(T(1));
  m[kShearing[static_cast<int>(kind)]][kChanged[static_cast<int>(kind)]] = s;
  return m;
}

}  // namespace sinew
