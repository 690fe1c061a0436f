// SPDX-License-Identifier: MIT
#include "runtime/animation/skeleton.h"

#include <algorithm>

#include "runtime/base/contract.h"

namespace sinew {

std::optional<std::uint32_t> Skeleton::find(std::string_view name) const noexcept {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - names.begin());
}

std::vector<float> mask_below(const Skeleton& skeleton, std::uint32_t joint, float weight) {
  CONTRACT(joint < skeleton.joint_count() && "a mask begins at a joint of the skeleton");
  std::vector<float> mask(skeleton.joint_count(), 0.0f);
  mask[joint] = weight;
  for (std::size_t j = joint + std::size_t{1}; j < mask.size(); ++j)
    if (const std::uint32_t parent = skeleton.parents[j]; parent != kNone) mask[j] = mask[parent];
  return mask;
}

}  // namespace sinew
