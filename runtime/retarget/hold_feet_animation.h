// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/bone_animation.h"
#include "runtime/retarget/feet_map.h"

namespace sinew {

/// Foot locking for a retargeted animation (hold_feet.h). Leg rotations, and translations of hips that come down, get
/// linear keys at all key times and 60 times a second. A leg that turns by no more than rounding keeps its tracks.
/// in   animation    of the source retargeted   that animation after retarget_animation
/// out  retargeted   new tracks for the joints of legs and hips; new bones are appended
/// cost O(duration * joints), allocates
void hold_feet(const FeetMap& feet, const Animation& animation, const Skeleton& source, const Skeleton& target,
               Animation& retargeted);

/// How far feet slide while they are on the ground. The slide of a contact is the largest distance of the ankle or toes
/// from the source's path. The path is scaled by the height ratio.
struct FootSlide {
  double largest = 0.0;  ///< over all contacts, in units of the target
  double mean = 0.0;
  std::size_t contacts = 0;
};

/// cost O(duration * joints), allocates
FootSlide measure_foot_slide(const FeetMap& feet, const Animation& animation, const Skeleton& source,
                             const Animation& retargeted, const Skeleton& target);

}  // namespace sinew
