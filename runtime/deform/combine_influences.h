// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "runtime/model/skin.h"

namespace sinew {

/// The influences of a primitive whose vertices share combinations of joints and weights (C06): a frame blends the
/// matrix of each combination once, and every vertex follows one matrix.
struct CombinedInfluences {
  std::uint32_t blended_vertices = 0;   ///< of two joints and more
  std::uint32_t combination_count = 0;  ///< of their joints and weights
  VertexInfluences combinations;        ///< one in each vertex's place; empty where vertices blend for themselves
  VertexInfluences vertices;     ///< one influence each: a joint of the skin, or a combination from `first_matrix` on
  std::size_t first_matrix = 0;  ///< of the combinations, among the matrices of the skin

  bool used() const noexcept { return !vertices.empty(); }
};

/// Combines where that is faster: a vertex spares the matrices after its first, a combination costs its own and the
/// place where its blend is kept. in   first_matrix   of the skin that is free: its joints and the combinations of
/// other primitives come before it cost O(influences + V log V), allocates
CombinedInfluences combine_influences(const VertexInfluences& influences, std::size_t first_matrix);

}  // namespace sinew
