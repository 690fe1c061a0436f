// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/bone_animation.h"
#include "runtime/retarget/feet_map.h"

namespace sinew {

/// Holds the feet of a retargeted animation: rotations of legs, and translations of hips that come down, get linear
/// keys of hold_feet (hold_feet.h) at all key times and 60 times a second. A leg that turns by no more than rounding
/// keeps its tracks.
/// in   animation    of the source
///      retargeted   the same by retarget_animation
/// out  retargeted   tracks of the joints of legs and hips, new ones behind
/// cost O(duration * joints), allocates
void hold_feet(const FeetMap& feet, const Animation& animation, const Skeleton& source, const Skeleton& target,
               Animation& retargeted);

/// How far feet slide: from when a foot comes down to when it goes up, the farthest that its ankle or its toes,
/// whichever is on the ground, strays from the source's path, which is scaled by heights.
struct FootSlide {
  double largest = 0.0;  ///< over all contacts, in units of the target
  double mean = 0.0;
  std::size_t contacts = 0;
};

/// cost O(duration * joints), allocates
FootSlide measure_foot_slide(const FeetMap& feet, const Animation& animation, const Skeleton& source,
                             const Animation& retargeted, const Skeleton& target);

}  // namespace sinew
