// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew::test {

/// Another order of the joints, as another file of the same character may have it. Each level is reversed, and an extra
/// root comes first.
/// out  the new index of each joint
inline std::vector<std::uint32_t> reordered_joints(const Skeleton& skeleton) {
  std::vector<std::uint32_t> places(skeleton.joint_count());
  for (std::size_t level = 0; level + 1 < skeleton.level_begin.size(); ++level) {
    const std::uint32_t begin = skeleton.level_begin[level], end = skeleton.level_begin[level + 1];
    for (std::uint32_t j = begin; j < end; ++j) places[j] = 1 + begin + end - 1 - j;
  }
  return places;
}

inline Skeleton reordered(const Skeleton& skeleton, const std::vector<std::uint32_t>& places) {
  const std::size_t count = skeleton.joint_count() + 1;
  Skeleton other;
  other.parents.assign(count, kNone);
  other.rest.resize(count);
  other.fixed_matrices = skeleton.fixed_matrices;
  other.fixed_matrix_of.assign(count, kNone);
  other.names.assign(count, "one more root");
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    const std::uint32_t parent = skeleton.parents[j];
    other.parents[places[j]] = parent == kNone ? kNone : places[parent];
    other.rest[places[j]] = skeleton.rest[j];
    other.fixed_matrix_of[places[j]] = skeleton.fixed_matrix_of[j];
    other.names[places[j]] = skeleton.names[j];
  }
  for (std::uint32_t j = 0; j < count; ++j) other.node_of_joint.push_back(j);
  other.joint_of_node = other.node_of_joint;
  for (const std::uint32_t begin : skeleton.level_begin) other.level_begin.push_back(begin == 0 ? 0 : begin + 1);
  return other;
}

/// The scene with its joints in the order of reordered_joints, with the same clips and models. Correctives are dropped.
inline Scene reordered(Scene scene) {
  const std::vector<std::uint32_t> places = reordered_joints(scene.skeleton);
  scene.skeleton = reordered(scene.skeleton, places);
  for (Animation& animation : scene.animations)
    for (BoneAnimation& bone : animation.bones) bone.joint = places[bone.joint];
  for (Skin& skin : scene.skins)
    for (std::uint32_t& joint : skin.joints) joint = places[joint];
  for (MeshInstance& instance : scene.instances) instance.joint = places[instance.joint];
  finish_scene(scene);
  return scene;
}

}  // namespace sinew::test
