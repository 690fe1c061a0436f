// SPDX-License-Identifier: MIT
#include "runtime/animation/constant_tracks.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

template <class V>
bool differ(const V& a, const V& b) noexcept {
  constexpr float kTolerance = 1e-5f;
  const float size = std::max(largest_component(a), largest_component(b));
  return largest_component(a - b) > kTolerance * std::max(size, 1.0f);
}

}  // namespace

RestDifference rest_difference(const Transform& local, const Transform& rest) noexcept {
  return {differ(local.translation, rest.translation),
          differ(aligned_with(rest.rotation, local.rotation), rest.rotation), differ(local.scale, rest.scale)};
}

void add_constant_tracks(std::span<const Transform> local, const Skeleton& skeleton, Animation& animation) {
  std::vector<RestDifference> moved(local.size());
  for (const BoneAnimation& bone : animation.bones) {
    RestDifference& of_joint = moved[bone.joint];
    of_joint.translation |= !bone.translation.empty();
    of_joint.rotation |= !bone.rotation.empty();
    of_joint.scale |= !bone.scale.empty();
  }
  for (std::uint32_t j = 0; j < local.size(); ++j) {
    if (skeleton.fixed_matrix_of[j] != kNone) continue;
    const RestDifference off = rest_difference(local[j], skeleton.rest[j]);
    BoneAnimation bone;
    bone.joint = j;
    if (off.translation && !moved[j].translation)
      bone.translation = {Interpolation::step, {0.0f}, {local[j].translation}};
    if (off.rotation && !moved[j].rotation) bone.rotation = {Interpolation::step, {0.0f}, {local[j].rotation}};
    if (off.scale && !moved[j].scale) bone.scale = {Interpolation::step, {0.0f}, {local[j].scale}};
    if (!bone.empty()) animation.bones.push_back(std::move(bone));
  }
}

}  // namespace sinew
