// SPDX-License-Identifier: MIT
#include "runtime/animation/joint_tracks.h"

#include <algorithm>

#include "runtime/base/contract.h"

namespace sinew {
namespace {

void take(const BoneAnimation& bone, JointTracks& tracks) noexcept {
  if (!bone.translation.empty()) tracks.translation = &bone.translation;
  if (!bone.rotation.empty()) tracks.rotation = &bone.rotation;
  if (!bone.scale.empty()) tracks.scale = &bone.scale;
}

}  // namespace

JointTracks tracks_of_joint(const Animation& animation, std::uint32_t joint) noexcept {
  JointTracks tracks;
  for (const BoneAnimation& bone : animation.bones)
    if (bone.joint == joint) take(bone, tracks);
  return tracks;
}

std::vector<JointTracks> tracks_by_joint(const Animation& animation, std::size_t joint_count) {
  std::vector<JointTracks> tracks(joint_count);
  for (const BoneAnimation& bone : animation.bones) {
    CONTRACT(bone.joint < joint_count);
    take(bone, tracks[bone.joint]);
  }
  return tracks;
}

BoneAnimation& last_bone_of(Animation& animation, std::uint32_t joint) {
  const auto last = std::find_if(animation.bones.rbegin(), animation.bones.rend(),
                                 [&](const BoneAnimation& bone) { return bone.joint == joint; });
  if (last != animation.bones.rend()) return *last;
  BoneAnimation& bone = animation.bones.emplace_back();
  bone.joint = joint;
  return bone;
}

}  // namespace sinew
