// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/animation/track.h"
#include "runtime/clip/clip_layout.h"

namespace sinew {

/// Rows of zeros for so many keys of a block's lanes.
void make_room(TrackBlock& block, std::size_t key_count);

/// Writes the keys of a track into one lane of rows that have room for them, with what its interpolation needs between
/// them (TrackBlock). Key times are looked at for squad only.
void fill_lane(TrackBlock& block, const Vec3Track& track, std::size_t lane);
void fill_lane(TrackBlock& block, const QuatTrack& track, std::size_t lane);

}  // namespace sinew
