// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/assets/skin.h"
#include "runtime/jobs/skin_linear.h"

namespace sinew::bench {

/// Linear-blend skinning that blends each combination of joints and weights once, however many vertices share it (C06). Not the
/// runtime's way: a quarter slower on a model with 2023 combinations of 2815 vertices, whose matrices are written and read once
/// more; a third faster on one with 60 of 956. It needs room for a matrix of each combination in every frame's memory.
class Combinations {
 public:
  Combinations(const VertexInfluences& influences, std::size_t joint_count);

  /// Bits as SkinLinearJob gives them.
  void skin(std::span<const JointMatrix> palette, const VertexInput& in, const VertexOutput& out);

 private:
  std::vector<std::size_t> counts_;     // influences of each combination of two joints and more
  std::vector<std::uint16_t> joints_;   // of all combinations, one after the other
  std::vector<float> weights_;
  VertexInfluences single_;             // one matrix a vertex
  std::vector<JointMatrix> matrices_;   // the joints' own, then those of combinations
};

}  // namespace sinew::bench
