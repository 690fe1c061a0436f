// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/bone_animation.h"

namespace sinew {

/// An animation that continues from its last pose into its first one, for loops that interpolate across the seam.
/// Without it a loop jumps from the last key to the first, as the file says (G12). Compile the result as any other
/// animation. Its duration is longer by the gap, so clocks, events and root motion work unchanged.
///
/// Every track (joints, morph weights, properties) gets one more key at the end of the gap: its first value. Rotations
/// of cubic tracks take the quaternion on the side of the last key, tangents included; all others keep the bits. The
/// gap is interpolated as the track is: step holds the last key, linear takes the short arc, a cubic spline keeps its
/// speeds on both sides of the seam. A track that ends before the animation holds its last value until then; one that
/// starts after 0 arrives at its first value at rest.
/// in   gap_s  time from the last pose to the first, usually one frame of the clip
/// err  not_finite;  unsupported (a gap of 0 or less, or one that vanishes in float next to the duration)
/// cost O(keys), allocates
Result<Animation> close_loop(const Animation& animation, double gap_s);

}  // namespace sinew
