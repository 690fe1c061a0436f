// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/model/mesh.h"

namespace sinew {

/// Reorders and duplicates the vertices of a primitive: attributes, influences, morph deltas and source_vertex. Does
/// not change `indices`, bounds and centers of rotation.
/// in    old_of_new[V']  old vertex of each new vertex; each old vertex occurs at least once; influence groups stay in
///       order
/// cost  O(V + V') for the attributes and for each morph target
void gather_vertices(Primitive& primitive, std::span<const std::uint32_t> old_of_new);

/// Reorders the vertices by a permutation and renumbers `indices` accordingly.
void permute_vertices(Primitive& primitive, std::span<const std::uint32_t> old_of_new);

}  // namespace sinew
