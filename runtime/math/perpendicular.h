// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/quaternion.h"

namespace sinew {

/// A unit vector perpendicular to unit u.
/// eq   normalise(u x e), e the coordinate axis with the largest angle to u, so the product never vanishes
template <class T>
Vec3<T> perpendicular_to(const Vec3<T>& u) noexcept {
  const Vec3<T> a(std::abs(u.x), std::abs(u.y), std::abs(u.z));
  const Vec3<T> axis = a.x <= a.y && a.x <= a.z ? Vec3<T>(1, 0, 0) : (a.y <= a.z ? Vec3<T>(0, 1, 0) : Vec3<T>(0, 0, 1));
  return normalised_or(glm::cross(u, axis), axis);
}

}  // namespace sinew
