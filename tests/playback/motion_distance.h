// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>

#include "runtime/math/dual_quaternion.h"
#include "tests/support/near.h"

namespace sinew::test {

/// How far two rigid motions are from each other: metres or radians, the larger one.
inline double apart(const DualQuatd& a, const DualQuatd& b) {
  return std::max(distance(translation_of(a), translation_of(b)), angle_between(a.real, b.real));
}

}  // namespace sinew::test
