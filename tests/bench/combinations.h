// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/deform/skin_linear.h"
#include "runtime/model/skin.h"

namespace sinew::bench {

/// Linear-blend skinning that blends each combination of joints and weights once, however many vertices share it (C06).
/// The runtime's way where combine_influences finds enough of them: a third faster on a model with 60 combinations of
/// 956 vertices, a quarter slower on one with 2023 of 2815, whose matrices are written and read once more.
class Combinations {
 public:
  Combinations(const VertexInfluences& influences, std::size_t joint_count);

  /// Bits as SkinLinearJob gives them.
  void skin(std::span<const JointMatrix> palette, const VertexInput& in, const VertexOutput& out);

 private:
  VertexInfluences combinations_;      // of two joints and more
  VertexInfluences single_;            // one matrix a vertex
  std::vector<JointMatrix> matrices_;  // the joints' own, then those of combinations
};

}  // namespace sinew::bench
