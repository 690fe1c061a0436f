// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "runtime/math/affine.h"

namespace sinew {

/// Rotation about a coordinate axis: 0 x, 1 y, 2 z, counter-clockwise seen from the tip of the axis.
/// eq   Real-Time Rendering, eqs. 4.5-4.7
template <class T>
Mat3<T> rotation_about_axis(int axis, T angle_rad) noexcept {
  const T c = std::cos(angle_rad), s = std::sin(angle_rad);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  Mat3<T> m(T(1));
  m[j][j] = c;
  m[j][k] = s;
  m[k][j] = -s;
  m[k][k] = c;
  return m;
}

/// Rotation about a point.
/// eq   X = T(p) R T(-p)   (Real-Time Rendering, eq. 4.8); p is the fixed point
template <class T>
AffineT<T> about_point(const Mat3<T>& rotation, const Vec3<T>& point) noexcept {
  return affine_from(rotation, point - rotation * point);
}

}  // namespace sinew
