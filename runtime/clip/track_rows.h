// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/animation/track.h"
#include "runtime/clip/clip_layout.h"

namespace sinew {

/// Gives a block rows of zeros for `key_count` keys.
void make_room(TrackBlock& block, std::size_t key_count);

/// Writes the keys of a track into one lane of rows that make_room made, with what the interpolation needs between keys
/// (TrackBlock). Reads key times for squad only.
void fill_lane(TrackBlock& block, const Vec3Track& track, std::size_t lane);
void fill_lane(TrackBlock& block, const QuatTrack& track, std::size_t lane);

}  // namespace sinew
