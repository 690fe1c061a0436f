// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/animation/bone_animation.h"
#include "runtime/clip/key_tolerances.h"

namespace sinew::cost {

/// How far the keys of each joint may be rounded so that no component takes more than `bits` over its own track's
/// range; 0, which keeps them in float, for tracks that cannot be packed (curves) or do not move. in   bits  1 to
/// PackedTrack::kMostBits
KeyTolerances keys_in_bits(const Animation& animation, std::uint32_t bits);

}  // namespace sinew::cost
