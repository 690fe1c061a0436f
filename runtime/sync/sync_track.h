// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/result.h"

namespace sinew {

/// The start of a beat: a foot that touches the ground. The beat lasts until the next one starts.
struct SyncBeat {
  double phase = 0.0;      ///< [0, 1) of the cycle
  std::uint32_t name = 0;  ///< any number; equal numbers are the same foot
};

/// The beats of a motion that repeats.
/// owns  nothing: views of the caller's memory
struct SyncTrack {
  std::span<const SyncBeat> beats;                     ///< phases increase; empty = one beat, the whole cycle
  double length_s = 1.0;                               ///< of one cycle, > 0
  std::span<const std::uint32_t> mirrored_names = {};  ///< [names] the mirrored name of each; empty = not mirrored
};

/// A place in the beats of a motion, counted over all rounds. Beat 0 is the first beat of round 0.
struct BeatPlace {
  std::int64_t beat = 0;
  double share = 0.0;  ///< [0, 1) of the beat

  friend bool operator==(const BeatPlace&, const BeatPlace&) = default;
};

/// A place in the cycles of a motion.
struct CyclePlace {
  std::int64_t round = 0;
  double phase = 0.0;  ///< [0, 1)

  friend bool operator==(const CyclePlace&, const CyclePlace&) = default;
};

/// err  not_finite, times_not_increasing (phases, or a phase outside [0, 1)), not_a_fraction (length_s is not above 0),
///      index_out_of_range (mirrored_names has no entry for a name);   cost O(beats)
SINEW_API ErrorCode check(const SyncTrack& track) noexcept;

/// Number of beats in one round, at least 1.
SINEW_API std::size_t beat_count(const SyncTrack& track) noexcept;
/// The name of a beat, counted over all rounds; its mirrored name if the track is mirrored.
SINEW_API std::uint32_t name_of_beat(const SyncTrack& track, std::int64_t beat) noexcept;
/// The share of the cycle that a beat takes, (0, 1].
SINEW_API double beat_length(const SyncTrack& track, std::int64_t beat) noexcept;

/// Convert between places in cycles and places in beats. The two are inverse to each other up to rounding of share or
/// phase. Rounds are integers, so many rounds add no error.
/// in   track  checked;   cost O(beats)
SINEW_API BeatPlace beat_place(const SyncTrack& track, const CyclePlace& place) noexcept;
SINEW_API CyclePlace cycle_place(const SyncTrack& track, const BeatPlace& place) noexcept;

}  // namespace sinew
