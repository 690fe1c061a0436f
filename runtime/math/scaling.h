// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"

namespace sinew {

/// eq   S(s) = diag(s.x, s.y, s.z)   (Real-Time Rendering, eq. 4.10)
template <class T>
Mat3<T> scaling(const Vec3<T>& s) noexcept {
  return {s.x, T(0), T(0), T(0), s.y, T(0), T(0), T(0), s.z};
}

/// Scaling along the three perpendicular axes of a rotated frame.
/// eq   X = F S(s) F^T, the columns of F are the axes   (Real-Time Rendering, eq. 4.12)
/// in   frame  orthonormal
template <class T>
Mat3<T> scaling_along(const Mat3<T>& frame, const Vec3<T>& s) noexcept {
  return Mat3<T>(frame[0] * s.x, frame[1] * s.y, frame[2] * s.z) * glm::transpose(frame);
}

/// Scaling along one unit axis; what is square to it stays.
/// eq   X = I + (s - 1) u u^T
template <class T>
Mat3<T> scaling_along(const Vec3<T>& unit_axis, T s) noexcept {
  return Mat3<T>(T(1)) + glm::outerProduct(unit_axis * (s - T(1)), unit_axis);
}

}  // namespace sinew
