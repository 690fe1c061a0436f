// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/bone_animation.h"

namespace sinew {

/// Numbers the tracks of joints and weights of an animation: 3 b for the translation of bone b, then its rotation and
/// its scale, then the weights. Calls `use(track)` with one of them.
template <class AnimationType, class Use>
decltype(auto) with_track(AnimationType& animation, std::size_t number, Use&& use) {
  if (number >= 3 * animation.bones.size()) return use(animation.weights[number - 3 * animation.bones.size()].weights);
  auto& bone = animation.bones[number / 3];
  if (number % 3 == 0) return use(bone.translation);
  if (number % 3 == 1) return use(bone.rotation);
  return use(bone.scale);
}
inline std::size_t track_count(const Animation& animation) noexcept {
  return 3 * animation.bones.size() + animation.weights.size();
}

/// The keys that a track keeps.
struct KeptKeys {
  std::size_t track = 0;            ///< number of the track, as in with_track
  std::vector<std::uint32_t> keys;  ///< indices of the keys, increasing
  bool rests = false;               ///< there is one key, and the track has its value at all times
  bool left_out = false;            ///< it rests at the value that the target has without a track, which stands for it
};

/// Lets tracks keep more keys than they need, where they can then share a list of key times with others and a file
/// takes fewer bytes (FileBytes).
/// cost O(lists^2 x keys); only lists of the same source are compared, and at most kMostLists of them
void share_key_times(const Animation& animation, std::vector<KeptKeys>& tracks);
inline constexpr std::size_t kMostLists = 128;

/// All key times of a track.
const std::vector<float>& times_of(const Animation& animation, std::size_t track);

/// Gives a track of `out` the kept keys of the same track of `animation`.
void set_keys(const Animation& animation, const KeptKeys& kept, Animation& out);

/// The animation with only these keys of these tracks. A track that rests has its key at its first key time, and a
/// track that is left out is empty. The clip begins and ends where it did: one track keeps its first key and one its
/// last, if no other track reaches so far.
Animation with_keys(const Animation& animation, std::span<const KeptKeys> tracks);

}  // namespace sinew
