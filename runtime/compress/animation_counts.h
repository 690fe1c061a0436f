// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <set>

#include "runtime/animation/bone_animation.h"

namespace sinew {

/// Number of keys of all tracks.
inline std::uint64_t key_count(const Animation& animation) {
  std::uint64_t keys = 0;
  for (const BoneAnimation& bone : animation.bones)
    keys += bone.translation.key_count() + bone.rotation.key_count() + bone.scale.key_count();
  for (const WeightAnimation& animated : animation.weights) keys += animated.weights.key_count();
  for (const PropertyTrack& track : animation.properties) keys += track.values.key_count();
  return keys;
}

/// Number of joints that have a track.
inline std::uint32_t animated_joints(const Animation& animation) {
  std::set<std::uint32_t> joints;
  for (const BoneAnimation& bone : animation.bones)
    if (!bone.empty()) joints.insert(bone.joint);
  return static_cast<std::uint32_t>(joints.size());
}

}  // namespace sinew
