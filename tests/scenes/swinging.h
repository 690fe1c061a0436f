// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "runtime/model/scene.h"

namespace sinew::scenes {

/// A clip in which every joint swings about its own axis with its own phase; the roots also travel. All tracks share
/// `key_count` evenly spaced key times, as exporters write them.
inline Animation swinging(const Skeleton& skeleton, std::size_t key_count, double keys_per_s = 30.0) {
  Animation animation;
  animation.name = "swinging";
  animation.duration_s = static_cast<double>(key_count - 1) / keys_per_s;
  std::vector<float> times_s;
  for (std::size_t k = 0; k < key_count; ++k)
    times_s.push_back(static_cast<float>(static_cast<double>(k) / keys_per_s));
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    BoneAnimation bone;
    bone.joint = j;
    bone.rotation = {Interpolation::linear, times_s, {}};
    for (std::size_t k = 0; k < key_count; ++k) {
      const double half = 0.3 * std::sin(0.7 * j + 4.0 * static_cast<double>(times_s[k]));
      const double x = std::sin(half) * std::cos(1.3 * j), z = std::sin(half) * std::sin(1.3 * j);
      bone.rotation.values.push_back(
          quat_xyzw(static_cast<float>(x), 0.0f, static_cast<float>(z), static_cast<float>(std::cos(half))));
    }
    if (skeleton.parents[j] == kNone) {
      bone.translation = {Interpolation::linear, times_s, {}};
      for (const float t : times_s)
        bone.translation.values.push_back(skeleton.rest[j].translation + glm::vec3(0.1f * t, 0, 0));
    }
    animation.bones.push_back(std::move(bone));
  }
  return animation;
}

}  // namespace sinew::scenes
