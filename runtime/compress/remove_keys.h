// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "runtime/animation/track.h"

namespace sinew {

/// Deviations of one track that keys_needed() has computed, for a search that asks again with other tolerances. It is
/// for one track with the same keys. Steps beyond a number are computed again and again, which bounds the memory.
class StepDeviations {
 public:
  explicit StepDeviations(std::size_t most_steps) : most_(most_steps) {}

  struct Step {
    double largest = 0.0;    ///< of the places that were looked at
    std::size_t places = 0;  ///< number of places that were looked at, in their order
  };

  /// The step from key `first` to key `last`; nullptr if it is not remembered.
  Step* find(std::size_t first, std::size_t last);

 private:
  std::vector<std::vector<Step>> from_;  // [first key][keys that the step leaves out - 1]
  std::size_t most_, count_ = 0;
};

/// A track that may change within a tolerance. The unit of the tolerance depends on the track:
///     translation   a length
///     rotation      how far a point one unit from the axis moves (radians, for small angles)
///     scale         a factor
///     weights       the metres by which all of them together displace vertices
struct LooseTrack {
  std::variant<Vec3Track*, QuatTrack*, WeightTrack*> track;
  double tolerance = 0.0;
  std::span<const float> metres_per_weight = {};  ///< [target_count] for weight tracks
  StepDeviations* known = nullptr;                ///< of this track; may be nullptr

  const std::vector<float>& times_s() const;
};

/// Chooses the keys to keep for tracks that share their key times. From each kept key it takes the longest step that
/// keeps every track within its tolerance. Dropped keys are checked, and points between them where curves are bent. The
/// first and last key and both sides of a jump (two keys at one time) are kept. Not for squad, whose curves depend on
/// neighbouring keys.
/// in   key_count  looks only at the first `key_count` keys, for estimates
/// out  indices of keys, increasing
/// cost O(tracks x keys x longest step), less where LooseTrack::known has it; a step is at most kLongestStep keys
std::vector<std::uint32_t> keys_needed(std::span<const LooseTrack> tracks, std::size_t key_count);
inline constexpr std::size_t kLongestStep = 64;

/// Removes all other keys.       in  keys  increasing
void keep_keys(const LooseTrack& track, std::span<const std::uint32_t> keys);

/// Replaces the track by one constant value if that is within its tolerance.     out  true if it was replaced
bool flatten_to_constant(const LooseTrack& track);

/// Splits tracks that share their key times into groups that keep different keys, if that takes fewer bytes. Otherwise
/// one track that needs every key would keep the keys of all. Every group costs kTimeGroupBytes for its own key search
/// and tables, so there are never more than a few.
/// in   tracks  at least one
/// cost a few times that of keys_needed
std::vector<std::vector<LooseTrack>> split_into_time_groups(std::vector<LooseTrack> tracks);
inline constexpr std::size_t kTimeGroupBytes = 512;

}  // namespace sinew
