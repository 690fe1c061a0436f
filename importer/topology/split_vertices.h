// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/model/mesh.h"

namespace sinew {

/// Duplicates vertices whose attributes must differ between faces. Copies of a vertex are adjacent, in the old order,
/// so influence groups stay contiguous. Copies attributes, influences, morph deltas and source_vertex. A vertex without
/// corners is kept once.
/// in    group[C]    one entry for each corner (entry of `indices`). Corners of one vertex share a copy if their groups
///       are equal; kNone = any copy. Copies of a vertex are ordered by increasing group
/// out   primitive   same number and order of indices; more vertices; bounds unchanged
/// cost  O(V' + C log(corners of a vertex))
void split_vertices(Primitive& primitive, std::span<const std::uint32_t> group);

}  // namespace sinew
