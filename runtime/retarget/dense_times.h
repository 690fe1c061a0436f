// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/bone_animation.h"

namespace sinew {

/// Times at which a motion is looked at that is no key: the given ones, each once, and between two of them equal steps
/// of at most a 60th of a second. Internal to retarget/
/// in   keys  one at least, in any order
std::vector<double> dense_times(std::vector<double> keys);

/// Those of all keys of joints, and of both ends.
std::vector<double> dense_times(const Animation& animation);

}  // namespace sinew
