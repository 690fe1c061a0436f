// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "runtime/animation/bone_animation.h"
#include "runtime/animation/skeleton.h"

/// The pose jobs in plain GLM code: arrays of structures, one binary search per track, glm::slerp, mat4.
namespace sinew::bench::glm_pose {

struct Joint {
  glm::vec3 translation{0};
  glm::quat rotation{1, 0, 0, 0};
  glm::vec3 scale{1};
};

template <class V>
struct Between {
  V first, second;
  float fraction;
};

template <class V>
Between<V> find(const Track<V>& track, float time_s) {
  const auto& times = track.times_s;
  const auto after = std::upper_bound(times.begin(), times.end(), time_s);
  if (after == times.begin()) return {track.values.front(), track.values.front(), 0};
  if (after == times.end()) return {track.values.back(), track.values.back(), 0};
  const auto k = static_cast<std::size_t>(after - times.begin()) - 1;
  return {track.values[k], track.values[k + 1], (time_s - times[k]) / (times[k + 1] - times[k])};
}

/// Samples linear tracks; other interpolations are not supported.
inline void sample(const Animation& animation, std::span<const Transform> rest, float time_s, std::span<Joint> pose) {
  for (std::size_t j = 0; j < pose.size(); ++j) pose[j] = {rest[j].translation, rest[j].rotation, rest[j].scale};
  for (const BoneAnimation& bone : animation.bones) {
    Joint& joint = pose[bone.joint];
    if (!bone.translation.empty()) {
      const auto at = find(bone.translation, time_s);
      joint.translation = glm::mix(at.first, at.second, at.fraction);
    }
    if (!bone.rotation.empty()) {
      const auto at = find(bone.rotation, time_s);
      joint.rotation = glm::slerp(at.first, at.second, at.fraction);
    }
    if (!bone.scale.empty()) {
      const auto at = find(bone.scale, time_s);
      joint.scale = glm::mix(at.first, at.second, at.fraction);
    }
  }
}

/// Weighted mean with rotations on the side of the first layer. Weights must add up to one.
inline void blend(std::span<const std::vector<Joint>> layers, std::span<const float> weights, std::span<Joint> pose) {
  for (std::size_t j = 0; j < pose.size(); ++j) {
    glm::vec3 translation(0), scale(0);
    glm::quat rotation(0, 0, 0, 0);
    for (std::size_t l = 0; l < layers.size(); ++l) {
      const Joint& from = layers[l][j];
      translation += from.translation * weights[l];
      scale += from.scale * weights[l];
      const float w = glm::dot(layers[0][j].rotation, from.rotation) < 0 ? -weights[l] : weights[l];
      rotation += from.rotation * w;
    }
    pose[j] = {translation, glm::normalize(rotation), scale};
  }
}

inline void local_to_model(const Skeleton& skeleton, std::span<const Joint> local, std::span<glm::mat4> model) {
  for (std::size_t j = 0; j < local.size(); ++j) {
    glm::mat4 m = glm::translate(glm::mat4(1), local[j].translation) * glm::mat4_cast(local[j].rotation) *
                  glm::scale(glm::mat4(1), local[j].scale);
    if (skeleton.fixed_matrix_of[j] != kNone)
      m = mat4_from_affine(skeleton.fixed_matrices[skeleton.fixed_matrix_of[j]]);
    model[j] = skeleton.parents[j] == kNone ? m : model[skeleton.parents[j]] * m;
  }
}

}  // namespace sinew::bench::glm_pose
