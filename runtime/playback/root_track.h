// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/playback/root_motion.h"

namespace sinew {

/// The root motion of one clip without its authoring keys, which an engine can then drop. It takes 32 bytes a key.
class SINEW_API RootTrack {
 public:
  /// A position and rotation of the character. Between keys translations are linear and rotations use slerp. Two keys
  /// with the same time are a jump.
  struct Key {
    float time_s;
    glm::vec3 translation;
    glm::quat turn;
  };

  /// A clip that does not move the character.
  RootTrack() noexcept = default;

  /// Makes a track that stays within `tolerance` of root_place, with as few keys as a greedy search finds.
  /// in   tolerance  metres and radians, above 0; at least 1e-7 of the largest coordinate, which is the accuracy of
  ///      float
  /// cost O(K log K) places for K keys of the root joint, allocates
  static RootTrack make(const BoneAnimation& root, const Transform& rest, const RootMotionParts& parts,
                        double tolerance);

  std::span<const Key> keys() const noexcept { return keys_; }

  /// Largest distance from root_place, in metres or radians, measured at eight times in each key interval.
  double measured_error() const noexcept { return measured_error_; }

  /// As root_place.     cost O(log keys), no allocation
  DualQuatd place(double time_s) const noexcept;

  /// As root_motion.    cost O(log keys + log turns), no allocation
  DualQuatd motion(const PlaybackStep& step) const noexcept;

 private:
  std::vector<Key> keys_;  // rising times
  double measured_error_ = 0.0;
};

/// The root joint without the motion of its track: the pose of a clip that plays on the spot. An engine that moves the
/// character by the track then has nothing to remove from the pose.
/// eq   L'(t) = E(t)^-1 L(t), L the joint's local transform without its scale, E the track's place
/// in   rest       as for RootTrack::make;   tolerance  metres and radians, above 0, as there
/// out  linear keys within `tolerance` of the equation, measured at eight times in each key interval; the scale track
///      is copied
/// cost as RootTrack::make
SINEW_API BoneAnimation bake_out_root(const BoneAnimation& root, const Transform& rest, const RootTrack& track,
                                      double tolerance);

}  // namespace sinew
