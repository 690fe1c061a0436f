// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/conventions.h"

namespace sinew {

/// How a stored quaternion became a unit one.
struct UnitRotation {
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  double length = 1.0;   ///< as stored
};

/// Numbers of a quaternion as stored, as a unit quaternion. Within the rounding of floats they are left alone, so that
/// stored keys stay exact (G06); zero becomes the identity (G52). Finite input.
UnitRotation unit_rotation(double x, double y, double z, double w) noexcept;

}  // namespace sinew
