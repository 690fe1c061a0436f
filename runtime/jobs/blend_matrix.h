// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/jobs/influence_dispatch.h"
#include "runtime/math/affine.h"

namespace sinew {

/// eq   M = sum(w_i * palette[joint_i])   (Real-Time Rendering, 4th ed., eq. 4.59); weights sum to 1.
/// A vertex that one joint moves alone takes the joint's matrix as it is.
template <int kCount>
Affine blend_matrix(std::span<const Affine> palette, const VertexJoints<kCount>& vertex) noexcept {
  const Affine& first = palette[vertex.joints[0]];
  if constexpr (kCount == 1) return first;
  const float w = vertex.weights[0];
  Affine m{{first.row[0] * w, first.row[1] * w, first.row[2] * w}};
  for (std::size_t i = 1; i < vertex.count(); ++i) {
    const Affine& next = palette[vertex.joints[i]];
    for (int r = 0; r < 3; ++r) m.row[r] += next.row[r] * vertex.weights[i];
  }
  return m;
}

}  // namespace sinew
