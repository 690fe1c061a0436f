// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/math/affine.h"
#include "runtime/math/transform.h"
#include "runtime/model/scene.h"

namespace sinew::test {

/// World matrices of all nodes at a time, by node of the file, in double from the keys of a clip.
/// in    clip   index, or kNone for the rest pose
inline std::vector<Affined> world_pose(const Scene& scene, std::uint32_t clip, double time_s) {
  const Skeleton& skeleton = scene.skeleton;
  std::vector<Transformd> local;
  for (const Transform& rest : skeleton.rest)
    local.push_back({Vec3<double>(rest.translation), quat_cast<double>(rest.rotation), Vec3<double>(rest.scale)});
  if (clip != kNone)
    for (const BoneAnimation& bone : scene.animations[clip].bones)
      local[bone.joint] = bone.interpolate(time_s, local[bone.joint]);
  std::vector<Affined> by_joint, by_node(local.size());
  for (std::size_t j = 0; j < local.size(); ++j) {
    const std::uint32_t parent = skeleton.parents[j];
    const Affined own = affine_from_transform(local[j]);
    by_joint.push_back(parent == kNone ? own : by_joint[parent] * own);
    by_node[skeleton.node_of_joint[j]] = by_joint[j];
  }
  return by_node;
}

}  // namespace sinew::test
