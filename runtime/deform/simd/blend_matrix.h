// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/deform/influence_dispatch.h"
#include "runtime/math/joint_matrix.h"

namespace sinew {

/// eq   M = sum(w_i * palette[joint_i])   (Real-Time Rendering, 4th ed., eq. 4.59); weights sum to 1.
/// A vertex that one joint moves alone takes the joint's matrix as it is.
template <int kCount>
Affine blend_matrix(std::span<const JointMatrix> palette, const VertexJoints<kCount>& vertex) noexcept {
  const JointMatrix& first = palette[vertex.joints[0]];
  if (vertex.count() == 1) return affine_from(first);
  JointMatrix sum;
  for (int c = 0; c < 4; ++c) sum.column[c] = first.column[c] * vertex.weights[0];
  for (std::size_t i = 1; i < vertex.count(); ++i) {
    const JointMatrix& next = palette[vertex.joints[i]];
    for (int c = 0; c < 4; ++c) sum.column[c] += next.column[c] * vertex.weights[i];
  }
  return affine_from(sum);
}

}  // namespace sinew
