// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/sync/sync_track.h"

namespace sinew {

/// Largest number of beats of a track for find_common_beats.
inline constexpr std::size_t kMostCommonBeats = 16;

/// Finds the beats in which motions can be synchronised, for gaits whose feet touch down in different orders or
/// numbers. It finds the longest cyclic sequence of names that occurs in all tracks in the same order. A walk and a
/// gallop share three of four feet. Among sequences of equal length, the one with the earliest beats of the first track
/// wins. Call it once for a group, and make tracks of the kept beats alone.
/// in   tracks  checked, each of at most kMostCommonBeats beats
/// out  kept    [tracks] a bit for each beat that is kept; all 0 if the tracks share no name
///      returns the number of beats of the sequence
/// cost O(2^beats * tracks * beats^2), no allocation
SINEW_API std::uint32_t find_common_beats(std::span<const SyncTrack> tracks, std::span<std::uint32_t> kept) noexcept;

}  // namespace sinew
