// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/sync/sync_track.h"

namespace sinew {

/// Most beats of a track that find_common_beats takes.
inline constexpr std::size_t kMostCommonBeats = 16;

/// Finds the beats that motions can meet in, for gaits whose feet touch down in another order, or not all of them. It
/// is the longest row of names that all tracks have in this order, round and round. A walk and a gallop meet in three
/// feet of four. Of rows of equal length, the one with earlier beats of the first track counts. Call it once for a
/// group, and make tracks of these beats alone.
/// in   tracks  checked, each of at most kMostCommonBeats beats
/// out  kept    [tracks] a bit for each beat; all 0 without a name in common
///      beats of the row
/// cost O(2^beats * tracks * beats^2), no allocation
SINEW_API std::uint32_t find_common_beats(std::span<const SyncTrack> tracks, std::span<std::uint32_t> kept) noexcept;

}  // namespace sinew
