// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/deform/influence_dispatch.h"
#include "runtime/math/normal_transform.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {

/// Rigid motion blended from the joints of one vertex, unit.
/// eq   d = sum(w sign(r . r_pivot) d_i) / |real part|, the pivot being the first influence: influences are ordered by
/// falling
///      weight, then rising joint (VertexInfluences), so it is the one with the largest weight (N17, N18). A blend
///      whose real part cancels (squared length below 1e-12) follows the pivot alone.   (Kavan et al. 2008, sec. 3.4)
template <int kCount>
DualQuat blend_motion(std::span<const RigidStretch> split, const VertexJoints<kCount>& vertex) noexcept {
  const DualQuat& pivot = split[vertex.joints[0]].rigid;
  if (vertex.count() == 1) return pivot;
  DualQuat sum{pivot.real * vertex.weights[0], pivot.dual * vertex.weights[0]};
  for (std::size_t i = 1; i < vertex.count(); ++i) {
    const DualQuat& next = split[vertex.joints[i]].rigid;
    const float w = quat_dot(pivot.real, next.real) < 0.0f ? -vertex.weights[i] : vertex.weights[i];
    sum.real = sum.real + next.real * w;
    sum.dual = sum.dual + next.dual * w;
  }
  const float squared = quat_dot(sum.real, sum.real);
  if (!(squared > 1e-12f)) return pivot;
  const float length = std::sqrt(squared);
  return {sum.real / length, sum.dual / length};
}

/// eq   S = sum(w S_i): phase one of two-phase dual-quaternion skinning, in bind space (N19)
template <int kCount>
Mat3<float> blend_stretch(std::span<const RigidStretch> split, const VertexJoints<kCount>& vertex) noexcept {
  float s[6] = {};
  for (std::size_t i = 0; i < vertex.count(); ++i) {
    const auto& stretch = split[vertex.joints[i]].stretch;
    for (int c = 0; c < 6; ++c) s[c] += stretch[c] * vertex.weights[i];
  }
  return {s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2]};
}

}  // namespace sinew
