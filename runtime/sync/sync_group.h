// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/sync/sync_track.h"

namespace sinew {

/// A motion of a group that plays in step.
struct SyncMember {
  SyncTrack track;
  double weight = 1.0;           ///< finite, >= 0
  std::uint32_t first_beat = 0;  ///< index of the track's beat that is beat 0 of the group
};

/// Motions that play in step: beat k of each member plays in segment k of the group. If members have different numbers
/// of beats per cycle, their common cycle has the least common multiple of these numbers as segments.
using SyncGroup = std::span<const SyncMember>;

/// Largest number of segments in a group's common cycle.
inline constexpr std::uint32_t kMostSegments = 5040;

/// err  those of a track; not_finite, negative_weight, index_out_of_range (first_beat), too_large (segments)
SINEW_API ErrorCode check(SyncGroup group) noexcept;

/// Number of segments of the common cycle, at least 1; 0 if there are more than kMostSegments.     cost O(members)
SINEW_API std::uint32_t common_segments(SyncGroup group) noexcept;

/// Seconds of the common cycle.
/// eq   sum w_i (N / n_i) length_i / sum w_i for N segments and n_i beats of member i; equal weights if all are 0
/// cost O(members)
SINEW_API double common_length_s(SyncGroup group) noexcept;

/// Shifts members so that their beats meet beats of the same name of the first member. Each first_beat becomes the
/// smallest index with the most equal names in a common cycle. Gaits with different orders of feet meet in as many feet
/// as possible.
/// in   group  checked, but for its first_beat;   cost O(members * segments * beats)
SINEW_API void align_names(std::span<SyncMember> group) noexcept;

/// The place of the group after a time step. Up to rounding, one long step and many short steps give the same place.
/// eq   segment k takes sum w_i length_i beat_length_i(k) / sum w_i seconds
/// in   group  checked;   dt_s  finite, of any sign
/// cost O(members * segments), whatever dt_s;   no allocation
SINEW_API BeatPlace advance(SyncGroup group, const BeatPlace& place, double dt_s) noexcept;

/// A member's place in its own cycle when the group is at `place`.
SINEW_API CyclePlace cycle_place(const SyncMember& member, const BeatPlace& place) noexcept;

/// Rule by which a new motion finds its start place from the motion that plays.
enum class SyncStart : std::uint8_t {
  phase,     ///< the same phase
  beat,      ///< the same share of the first beat of the same name; if there is none, of the beat with the same index
  time_left  ///< as many seconds before its end as the old motion has left; its start if it is shorter
};

/// in   from, to  checked;   place  of `from`
/// out  in round 0;   cost O(beats)
SINEW_API CyclePlace start_place(const SyncTrack& from, const CyclePlace& place, const SyncTrack& to,
                                 SyncStart rule) noexcept;

}  // namespace sinew
