// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <span>

#include "runtime/base/result.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/math/negligible.h"
#include "runtime/model/morph_set.h"

namespace sinew {

/// Weights below this are zero: they would only make denormal numbers, which some processors add a hundred times slower
/// (N26).
inline bool is_active_weight(float weight) noexcept { return std::abs(weight) >= kNegligible; }

/// Adds the displacements of all targets whose weight is not zero. Normals and tangents come out unnormalised when the
/// vertices are skinned afterwards, and are normalised here otherwise (G45).
/// eq   v' = v + sum(weight[i] * delta[i]): the displacements are summed first, the base is added last (hard case
/// "morph":
///      small displacements on a large base keep their digits)
/// in   vertices[V], weights[T], any sign and size
/// out  must not overlap `vertices`;   scratch[V]  displacement sums
/// err  size_mismatch, index_out_of_range, not_finite     cost O(V + active deltas), no allocation
struct MorphVerticesJob {
  const MorphSet* morphs = nullptr;
  std::span<const float> weights;
  VertexInput vertices;
  VertexOutput out;
  std::span<glm::vec3> scratch;
  bool normalise = true;
};

ErrorCode check(const MorphVerticesJob& job) noexcept;
void run(const MorphVerticesJob& job) noexcept;

}  // namespace sinew
