// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/math/negligible.h"
#include "runtime/model/morph_set.h"

namespace sinew {

/// Smaller weights count as zero: they would only make denormal numbers, which some processors add a hundred times
/// slower (N26).
inline bool is_active_weight(float weight) noexcept { return std::abs(weight) >= kNegligible; }

/// Adds the displacements of all targets whose weight is not zero. Normals and tangents stay unnormalised where the
/// vertices are skinned afterwards, and are normalised here otherwise (G45).
/// eq   v' = v + sum(weight[i] * delta[i]). Displacements are summed first and the base is added last, so that small
///      displacements of a large base keep their digits.
/// in   vertices[V], weights[T], any sign and size
/// out  must not overlap `vertices`;   scratch[V]  sums of displacements
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
void run_unchecked(const MorphVerticesJob& job) noexcept;

/// Adds the COLOR_0 displacements of all targets whose weight is not zero.
/// eq   c' = clamp(c + sum(weight[i] * delta[i]), 0, 1)   (glTF 2.0, "Morph Targets"; G47)
/// in   colors[V], weights[T], any sign and size
/// out  out[V]     must not overlap `colors`
/// cost O(V + active deltas), no allocation
void morph_colors(const MorphSet& morphs, std::span<const float> weights, std::span<const glm::vec4> colors,
                  std::span<glm::vec4> out) noexcept;

}  // namespace sinew
