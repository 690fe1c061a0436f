// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// The pose that counts as standing still: mirroring and retargeting carry over how far joints have moved from it.
enum class PoseReference : std::uint8_t {
  rest,  ///< the transforms of the nodes
  bind,  ///< the pose in which meshes were bound to their skins (model/bind_pose.h)
  given  ///< a pose of the caller, for example a frame of a clip
};

/// True if a reference pose is the rest pose, bit for bit, or empty.
inline bool is_rest_pose(const Skeleton& skeleton, std::span<const Transform> reference) noexcept {
  return reference.empty() ||
         std::equal(reference.begin(), reference.end(), skeleton.rest.begin(), skeleton.rest.end());
}

}  // namespace sinew
