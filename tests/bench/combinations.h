// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/deform/skin_linear.h"
#include "runtime/model/skin.h"

namespace sinew::bench {

/// Linear-blend skinning that blends the matrix of each combination of joints and weights once, however many vertices
/// share it. The runtime does so where combine_influences() finds few combinations for many vertices. If nearly every
/// vertex has its own combination, this is slower: every blended matrix is written and read once more (rows
/// skin_linear/MODEL).
class Combinations {
 public:
  Combinations(const VertexInfluences& influences, std::size_t joint_count);

  /// Gives the same bits as SkinLinearJob.
  void skin(std::span<const JointMatrix> palette, const VertexInput& in, const VertexOutput& out);

 private:
  VertexInfluences combinations_;      // vertices of two or more joints
  VertexInfluences single_;            // one matrix a vertex
  std::vector<JointMatrix> matrices_;  // those of the joints, then those of the combinations
};

}  // namespace sinew::bench
