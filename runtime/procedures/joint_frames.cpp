// SPDX-License-Identifier: MIT
#include "runtime/procedures/joint_frames.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/math/decompose.h"
#include "runtime/math/interpolate.h"

namespace sinew {

Affined local_matrix(const Skeleton& skeleton, const PoseSpan& local, std::uint32_t joint) noexcept {
  const std::uint32_t fixed = skeleton.fixed_matrix_of[joint];
  if (fixed != kNone) return affine_cast<double>(skeleton.fixed_matrices[fixed]);
  return affine_from_transform(local_of(local, joint));
}

Affined model_matrix(const Skeleton& skeleton, const PoseSpan& local, std::uint32_t joint) noexcept {
  if (joint == kNone) return {};
  Affined model = local_matrix(skeleton, local, joint);
  for (std::uint32_t j = skeleton.parents[joint]; j != kNone; j = skeleton.parents[j])
    model = local_matrix(skeleton, local, j) * model;
  return model;
}

Quat<double> model_rotation(const Skeleton& skeleton, const PoseSpan& local, std::uint32_t joint) noexcept {
  Quat<double> rotation = quat_identity<double>();
  for (std::uint32_t j = joint; j != kNone; j = skeleton.parents[j]) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[j];
    rotation =
        (fixed == kNone ? quat_cast<double>(local.get(j).rotation)
                        : decompose_polar(linear_part(affine_cast<double>(skeleton.fixed_matrices[fixed]))).quat) *
        rotation;
  }
  return normalised(rotation);
}

Affined matrix_below(const Skeleton& skeleton, const PoseSpan& local, std::uint32_t ancestor,
                     std::uint32_t joint) noexcept {
  Affined below;
  for (std::uint32_t j = joint; j != ancestor; j = skeleton.parents[j])
    below = j == joint ? local_matrix(skeleton, local, j) : local_matrix(skeleton, local, j) * below;
  return below;
}

Quat<double> part_of_turn(const Quat<double>& from, const Quat<double>& to, double share) noexcept {
  constexpr double kFrom_rad = 2.6;
  if (share == 0.0 || share == 1.0) return slerp_short_arc(from, to, share);
  const double turn = rotation_angle_between(from, to);
  const double close = std::clamp((turn - kFrom_rad) / (std::numbers::pi - kFrom_rad), 0.0, 1.0);
  return slerp_short_arc(from, to, share + ((share < 0.5 ? 0.0 : 1.0) - share) * close);
}

}  // namespace sinew
