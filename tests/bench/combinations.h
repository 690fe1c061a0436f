// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/deform/skin_linear.h"
#include "runtime/model/skin.h"

namespace sinew::bench {

/// Linear-blend skinning that blends the matrix of each combination of joints and weights once, however many vertices
/// share it. The runtime does so where combine_influences finds few combinations for many vertices. With nearly one
/// combination a vertex it is slower, since every blended matrix is written and read once more (rows
/// skin_linear/MODEL).
class Combinations {
 public:
  Combinations(const VertexInfluences& influences, std::size_t joint_count);

  /// The same bits as SkinLinearJob.
  void skin(std::span<const JointMatrix> palette, const VertexInput& in, const VertexOutput& out);

 private:
  VertexInfluences combinations_;      // of two or more joints
  VertexInfluences single_;            // one matrix a vertex
  std::vector<JointMatrix> matrices_;  // of the joints, then of the combinations
};

}  // namespace sinew::bench
