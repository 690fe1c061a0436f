// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "runtime/model/skin.h"

namespace sinew {

/// Influences of a primitive whose vertices share combinations of joints and weights (C06): a frame blends the matrix
/// of each combination once, and every vertex follows one matrix.
struct CombinedInfluences {
  std::uint32_t blended_vertices = 0;   ///< vertices with two joints or more
  std::uint32_t combination_count = 0;  ///< distinct combinations of these vertices
  VertexInfluences combinations;        ///< one combination per vertex; empty = not combined
  VertexInfluences vertices;            ///< one influence each: a joint of the skin, or `first_matrix` + combination
  std::size_t first_matrix = 0;         ///< index of the first combination among the matrices of the skin

  bool used() const noexcept { return !vertices.empty(); }
};

/// Combines influences where that is faster: combining saves each vertex the matrices after its first one, and costs
/// the matrices of each combination and the memory of its blend.
/// in   first_matrix  index of the first free matrix of the skin, after its joints and the combinations of others
/// cost O(influences + V log V), allocates
CombinedInfluences combine_influences(const VertexInfluences& influences, std::size_t first_matrix);

}  // namespace sinew
