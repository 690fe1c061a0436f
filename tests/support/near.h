// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include "runtime/math/affine.h"
#include "runtime/math/quaternion.h"

namespace sinew::test {

/// Unit roundoff of float32: the unit of tolerances. A tolerance of 4 * kEps on a value near 1 is 4 half-ulps.
inline constexpr double kEps = 0x1p-24;

/// Distances are computed in double, because float would add errors of its own. With a NaN the result is NaN, which no
/// tolerance accepts.
template <class T>
double distance(const Vec3<T>& a, const Vec3<T>& b) {
  return safe_length(Vec3<double>(a) - Vec3<double>(b));
}

/// Rotation angle in radians between two quaternions of any length, q and -q equal.
template <class A, class B>
double angle_between(const Quat<A>& a, const Quat<B>& b) {
  return rotation_angle_between(quat_cast<double>(a), quat_cast<double>(b));
}

/// Largest absolute difference of the twelve numbers of two matrices.
template <class T>
double distance(const AffineT<T>& a, const AffineT<T>& b) {
  double worst = 0;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) {
      const double d = std::abs(static_cast<double>(a.row[r][c]) - static_cast<double>(b.row[r][c]));
      if (std::isnan(d)) return d;
      worst = std::max(worst, d);
    }
  return worst;
}

template <class T>
::testing::AssertionResult is_near(const Vec3<T>& a, const Vec3<T>& b, double tolerance) {
  const double d = distance(a, b);
  if (d <= tolerance) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "(" << a.x << ", " << a.y << ", " << a.z << ") and (" << b.x << ", " << b.y
                                       << ", " << b.z << ") are " << d << " apart, allowed " << tolerance;
}

template <class T>
::testing::AssertionResult is_near(const AffineT<T>& a, const AffineT<T>& b, double tolerance) {
  const double d = distance(a, b);
  if (d <= tolerance) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "matrices are " << d << " apart, allowed " << tolerance;
}

/// True if both are the same rotation within `tolerance_rad` and of unit length within 4 ulp of float. q and -q are
/// equal.
template <class A, class B>
::testing::AssertionResult same_rotation(const Quat<A>& a, const Quat<B>& b, double tolerance_rad) {
  const double d = angle_between(a, b);
  const double la = safe_length(quat_cast<double>(a)), lb = safe_length(quat_cast<double>(b));
  if (d <= tolerance_rad && std::abs(la - 1) <= 8 * kEps && std::abs(lb - 1) <= 8 * kEps)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "(" << a.x << ", " << a.y << ", " << a.z << ", " << a.w << ") and (" << b.x
                                       << ", " << b.y << ", " << b.z << ", " << b.w << ") are " << d
                                       << " rad apart, allowed " << tolerance_rad << "; lengths " << la << ", " << lb;
}

}  // namespace sinew::test
