// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/bone_animation.h"

namespace sinew::tool {

/// Animations with linear keys at k / fps and at both ends of each track. STEP tracks keep their keys: at
/// other times the steps would blur. A track of equal values keeps one key, or two if the clip would otherwise end
/// sooner. Properties keep their keys.
std::vector<Animation> resample_clips(std::vector<Animation> animations, double fps);

}  // namespace sinew::tool
