// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/animation/skeleton.h"
#include "runtime/math/quaternion.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Matrix of one joint of a pose in the space of its parent, in double. The rotation of the pose is normalised.
inline Affined exact_local_matrix(const Skeleton& skeleton, const PoseSpan& pose, std::uint32_t joint) noexcept {
  if (const std::uint32_t fixed = skeleton.fixed_matrix_of[joint]; fixed != kNone)
    return affine_cast<double>(skeleton.fixed_matrices[fixed]);
  const Transform local = pose.get(joint);
  return affine_from_transform(Transformd{Vec3<double>(local.translation),
                                          normalised(quat_cast<double>(local.rotation)), Vec3<double>(local.scale)});
}

/// Matrix of one joint of a pose in model space, in double; the identity for kNone.     cost O(depth)
inline Affined exact_model_matrix(const Skeleton& skeleton, const PoseSpan& pose, std::uint32_t joint) noexcept {
  Affined m;
  for (; joint != kNone; joint = skeleton.parents[joint]) m = exact_local_matrix(skeleton, pose, joint) * m;
  return m;
}

}  // namespace sinew
