// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/skeleton.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/math/decompose.h"

namespace sinew {

/// Local rest transform of a joint; a fixed matrix is decomposed. Internal to retarget/
inline Transformd rest_transform(const Skeleton& skeleton, std::uint32_t joint) noexcept {
  const std::uint32_t fixed = skeleton.fixed_matrix_of[joint];
  if (fixed == kNone) return in_double(skeleton.rest[joint]);
  return decompose_trs(affine_cast<double>(skeleton.fixed_matrices[fixed])).transform;
}

}  // namespace sinew
