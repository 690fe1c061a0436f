// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/model/mesh.h"

namespace sinew {

/// Gives corners of one vertex their own copies of it, where an attribute must differ between faces. Copies of a vertex
/// lie next to each other in the old order, so influence groups stay whole. Attributes, influences, morph deltas and
/// source_vertex are copied along; a vertex without corners is kept once.
/// in    group[C]    one entry for each corner (entry of `indices`): corners of one vertex share a copy when their
/// groups
///                   are equal; kNone = any copy will do. Copies of a vertex are ordered by rising group
/// out   primitive   as many indices in the same order; vertex_count() grows; bounds are unchanged
/// cost  O(V' + C log(corners of a vertex))
void split_vertices(Primitive& primitive, std::span<const std::uint32_t> group);

}  // namespace sinew
