// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

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

/// Same, of a reference pose; an empty one is the rest pose. Fixed matrices stay.
inline Transformd reference_transform(const Skeleton& skeleton, std::span<const Transform> reference,
                                      std::uint32_t joint) noexcept {
  const bool is_rest = reference.empty() || skeleton.fixed_matrix_of[joint] != kNone;
  return is_rest ? rest_transform(skeleton, joint) : in_double(reference[joint]);
}

}  // namespace sinew
