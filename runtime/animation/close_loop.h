// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/bone_animation.h"

namespace sinew {

/// An animation that runs on from its last pose into its first one, for loops that shall interpolate across the seam:
/// clips are otherwise played as the file has them, and a loop jumps from the last key to the first (G12). Compile it
/// as any other; its duration is longer by the gap, so that clocks, events and root motion need to know nothing of it.
///
/// Every track gets one more key, at the end of the gap: its first value, bit for bit. Between the last key and that
/// one it goes as the track's own interpolation goes: step holds, linear takes the short arc, a cubic spline keeps the
/// speeds that it has on either side of the seam. A track that ends before the animation, or starts after 0, rests
/// there.
/// in   gap_s  time from the last pose to the first, most often one frame of the clip
/// err  not_finite;  unsupported (a gap of 0 or less, or one that float key times cannot tell at that duration)
/// cost O(keys), allocates
Result<Animation> close_loop(const Animation& animation, double gap_s);

}  // namespace sinew
