// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/animation/track.h"
#include "runtime/clip/clip_layout.h"

namespace sinew {

/// Allocates the rows of a block for `key_count` keys, filled with zeros.
void make_room(TrackBlock& block, std::size_t key_count);

/// Writes the keys of a track into one lane, with the planes that its interpolation needs (TrackBlock). Call make_room
/// first.
void fill_lane(TrackBlock& block, const Vec3Track& track, std::size_t lane);
void fill_lane(TrackBlock& block, const QuatTrack& track, std::size_t lane);

}  // namespace sinew
