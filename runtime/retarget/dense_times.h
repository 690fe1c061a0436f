// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/bone_animation.h"

namespace sinew {

/// Sample times for motions that have no keys of their own: the given times, sorted and without repetitions. Gaps are
/// filled in equal steps of at most 1/60 s. Internal to retarget/
/// in   keys  at least one, in any order
std::vector<double> dense_times(std::vector<double> keys);

/// Same, from the key times of all joints and both ends of the animation.
std::vector<double> dense_times(const Animation& animation);

}  // namespace sinew
