// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/bone_animation.h"

namespace sinew {

/// A copy of an animation that continues from its last pose into its first one, for loops without a jump at the seam.
/// By itself, a loop jumps from the last key to the first, as glTF defines it. The copy is an ordinary animation whose
/// duration is longer by `gap_s`, so clocks, events and root motion need no change.
///
/// Every track (joints, morph weights, properties) gets one more key, with its first value, at the end of the gap. It
/// has the same bits, except that rotations of cubic tracks and their tangents are negated if the last key needs it.
/// The gap is interpolated as the rest of the track: step holds the last key, and linear takes the short arc. A cubic
/// spline has the same speed on both sides of the seam. A track that ends before the animation holds its last value
/// until the end. One that starts after 0 arrives at its first value with speed 0.
/// in   gap_s  time from the last pose to the first, usually one frame of the clip
/// err  not_finite;  unsupported (gap_s is not positive, or too short to change the duration in float)
/// cost O(keys), allocates
Result<Animation> close_loop(const Animation& animation, double gap_s);

}  // namespace sinew
