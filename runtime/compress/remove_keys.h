// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "runtime/animation/track.h"

namespace sinew {

/// A track that may change as long as it stays within a tolerance of what it is. The tolerance is a length for
/// translations; for rotations the distance by which a point one unit from the axis moves (radians, for small ones); a
/// factor for scales; and for weights the metres by which they displace vertices together.
struct LooseTrack {
  std::variant<Vec3Track*, QuatTrack*, WeightTrack*> track;
  double tolerance = 0.0;
  std::span<const float> metres_per_weight = {};  ///< [target_count] of weights

  const std::vector<float>& times_s() const;
};

/// The keys that are enough for all of the tracks, which share their key times. From each key it takes the longest step
/// that leaves every track, played by its own interpolation, within its tolerance at all keys that are left out, and
/// between them where curves are bent. First and last key and both sides of a jump (G13) stay. Not for squad, whose
/// curves depend on the keys around.
/// in   key_count  of the first keys only, for estimates
/// out  numbers of keys, increasing
/// cost O(tracks x keys x longest step); a step is at most kLongestStep keys
std::vector<std::uint32_t> keys_needed(std::span<const LooseTrack> tracks, std::size_t key_count);
inline constexpr std::size_t kLongestStep = 64;

/// Leaves out all other keys.       in  keys  increasing
void keep_keys(const LooseTrack& track, std::span<const std::uint32_t> keys);

/// Makes the track one value from its first to its last key if that is within its tolerance.
/// out  whether it is
bool hold_still(const LooseTrack& track);

/// Splits tracks that share their key times into groups that each keep keys of their own, where that takes fewer bytes:
/// a track that needs every key would otherwise keep them for all. Every group has a key search and tables of its own
/// (kTimeGroupBytes) in the clip, so there are never more than a few.
/// in   tracks  at least one
/// cost of keys_needed, a few times
std::vector<std::vector<LooseTrack>> split_into_time_groups(std::vector<LooseTrack> tracks);
inline constexpr std::size_t kTimeGroupBytes = 512;

}  // namespace sinew
