// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/bone_animation.h"

namespace sinew {

/// Times at which feet are looked at: those of all keys, and as many between as make 60 a second. Internal to
/// retarget/     cost O(K log K), allocates
std::vector<double> leg_times(const Animation& animation);

}  // namespace sinew
