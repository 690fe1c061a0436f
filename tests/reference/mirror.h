// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/math/matrix_rotation.h"

/// A mirrored pose by its definition in model space, in plain double matrices.
namespace sinew::reference {

/// Rotations in model space: products of local rotations down the hierarchy.
inline std::vector<Mat3<double>> model_rotations(const Skeleton& skeleton, std::span<const Transform> local) {
  std::vector<Mat3<double>> model;
  for (std::size_t j = 0; j < local.size(); ++j) {
    const Mat3<double> own = matrix_from_unit_quat(normalised(quat_cast<double>(local[j].rotation)));
    model.push_back(skeleton.parents[j] == kNone ? own : model[skeleton.parents[j]] * own);
  }
  return model;
}

inline Mat3<double> reflection(const Vec3<double>& normal) {
  return Mat3<double>(1.0) - 2.0 * glm::outerProduct(normal, normal);
}

/// eq   N_j = G_j W_j^T;  G'_p = S N_j S W_p;  R'_p = G'_P'^T G'_p
///      t'_p = r_p + W_P'^T S W_P (t_j - r_j);  s'_p = r_p * sum over columns of (W_p^T S W_j)^2 (s_j / r_j)
/// in   rest, local, partner  [J];  partners hang on partners
inline std::vector<Transformd> mirrored_pose(const Skeleton& skeleton, std::span<const Transform> rest,
                                             std::span<const Transform> local, std::span<const std::uint32_t> partner,
                                             const Vec3<double>& normal) {
  const std::vector<Mat3<double>> rested = model_rotations(skeleton, rest), posed = model_rotations(skeleton, local);
  const Mat3<double> s = reflection(normal);
  std::vector<Mat3<double>> model(local.size());
  for (std::size_t p = 0; p < local.size(); ++p) {
    const std::uint32_t j = partner[p];
    model[p] = s * posed[j] * glm::transpose(rested[j]) * s * rested[p];
  }
  std::vector<Transformd> mirrored;
  for (std::size_t p = 0; p < local.size(); ++p) {
    const std::uint32_t j = partner[p], above = skeleton.parents[p], above_source = skeleton.parents[j];
    const Mat3<double> turned = above == kNone ? s : glm::transpose(rested[above]) * s * rested[above_source];
    const Transformd own = in_double(rest[p]), from = in_double(rest[j]), now = in_double(local[j]);
    const Mat3<double> rotation = above == kNone ? model[p] : glm::transpose(model[above]) * model[p];
    const Mat3<double> axes = glm::transpose(rested[p]) * s * rested[j];
    Vec3<double> scale(0.0);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) scale[r] += axes[c][r] * axes[c][r] * now.scale[c] / from.scale[c] * own.scale[r];
    mirrored.push_back(
        {own.translation + turned * (now.translation - from.translation), quat_from_matrix(rotation), scale});
  }
  return mirrored;
}

}  // namespace sinew::reference
