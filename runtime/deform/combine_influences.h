// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "runtime/base/api.h"
#include "runtime/model/skin.h"

namespace sinew {

/// Influences of a primitive whose vertices share combinations of joints and weights. A frame blends the matrix of each
/// combination once (BlendCombinationsJob), and every vertex follows one matrix.
struct CombinedInfluences {
  std::uint32_t blended_vertices = 0;   ///< vertices with two or more joints
  std::uint32_t combination_count = 0;  ///< distinct combinations among these vertices
  VertexInfluences combinations;        ///< one "vertex" per combination; empty = not combined
  VertexInfluences vertices;  ///< one influence each: a joint of the skin, or `first_matrix` + index of the combination
  std::size_t first_matrix = 0;  ///< index of the first combination among the matrices of the skin

  bool used() const noexcept { return !vertices.empty(); }
};

/// Combines influences if that is faster, else returns an unused CombinedInfluences. Combining saves every vertex the
/// blend of its matrices. It costs one blend, and its memory, per combination.
/// in   first_matrix  first free index of the skin's matrices, after its joints and the combinations of other
///      primitives
/// cost O(influences + V log V), allocates
SINEW_API CombinedInfluences combine_influences(const VertexInfluences& influences, std::size_t first_matrix);

}  // namespace sinew
