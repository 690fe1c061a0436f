// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/transform.h"

namespace sinew {

/// One whole key of a joint: its transform in its parent's space at a time.
template <class T>
struct KeyframeT {
  double time_s = 0.0;
  Vec3<T> translation{T(0)};
  Quat<T> rotation{T(1), T(0), T(0), T(0)};  // w x y z
  Vec3<T> scale{T(1)};
};

using Keyframe = KeyframeT<float>;

}  // namespace sinew
