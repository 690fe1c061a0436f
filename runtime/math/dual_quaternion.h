// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/conventions.h"

namespace sinew {

/// A dual quaternion r + e d. For a rigid motion r is the unit rotation and d = t r / 2 (Kavan et al. 2008).
template <class T>
struct DualQuatT {
  Quat<T> real{T(1), T(0), T(0), T(0)};  // w x y z
  Quat<T> dual{T(0), T(0), T(0), T(0)};
};

using DualQuat = DualQuatT<float>;

}  // namespace sinew
