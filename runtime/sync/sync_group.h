// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/sync/sync_track.h"

namespace sinew {

/// A motion that plays in step with others.
struct SyncMember {
  SyncTrack track;
  double weight = 1.0;           ///< finite, >= 0
  std::uint32_t first_beat = 0;  ///< of the track, which stands at beat 0 of the group
};

/// Motions in step: segment k of the group is beat k of each member. Members with n beats in their cycles have a common
/// cycle of as many segments as the least common multiple of all n.
using SyncGroup = std::span<const SyncMember>;

/// Longest common cycle that groups may have.
inline constexpr std::uint32_t kMostSegments = 5040;

/// err  those of a track; not_finite, negative_weight, index_out_of_range (first_beat), too_large (segments)
SINEW_API ErrorCode check(SyncGroup group) noexcept;

/// Segments of the common cycle, at least 1; 0 if there are more than kMostSegments.     cost O(members)
SINEW_API std::uint32_t common_segments(SyncGroup group) noexcept;

/// Seconds of the common cycle.
/// eq   sum w_i (N / n_i) length_i / sum w_i;  without weights, of equal ones
/// cost O(members)
SINEW_API double common_length_s(SyncGroup group) noexcept;

/// Turns members so that equal names meet those of the first one. Each first_beat becomes the smallest one with the
/// most equal names in a common cycle. Gaits whose order of feet differs meet in as many feet as they can.
/// in   group  checked, but for its first_beat;   cost O(members * segments * beats)
SINEW_API void align_names(std::span<SyncMember> group) noexcept;

/// Where a step of time leads. It does not matter how steps are cut, up to rounding.
/// eq   segment k takes sum w_i length_i beat_length_i(k) / sum w_i seconds
/// in   group  checked;   dt_s  finite, of any sign
/// cost O(members * segments), whatever dt_s;   no allocation
SINEW_API BeatPlace advance(SyncGroup group, const BeatPlace& place, double dt_s) noexcept;

/// A member's place in its cycle, where the group stands at `place`.
SINEW_API CyclePlace cycle_place(const SyncMember& member, const BeatPlace& place) noexcept;

/// How a motion that begins finds its place from the one that plays.
enum class SyncStart : std::uint8_t {
  phase,     ///< the same phase
  beat,      ///< the same share of the first beat of the same name; without one, of the beat of the same index
  time_left  ///< as many seconds before its end; its start if it is shorter
};

/// in   from, to  checked;   place  of `from`
/// out  in round 0;   cost O(beats)
SINEW_API CyclePlace start_place(const SyncTrack& from, const CyclePlace& place, const SyncTrack& to,
                                 SyncStart rule) noexcept;

}  // namespace sinew
