// SPDX-License-Identifier: MIT
#pragma once
#include <numbers>

#include "runtime/math/conventions.h"

namespace sinew::ozz {

using V = Vec3<double>;
inline constexpr double kPi = std::numbers::pi;
inline const V kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

}  // namespace sinew::ozz
