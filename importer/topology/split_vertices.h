// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/model/mesh.h"

namespace sinew {

/// Gives corners of one vertex their own copies of it, where an attribute must differ between faces.
/// Copies of a vertex lie next to each other in the old order, so influence groups stay whole; attributes, influences,
/// morph deltas and source_vertex go with each copy, and a vertex without any corner is kept once.
/// in   group[C]   per corner (entry of `indices`): corners of one vertex share a copy when their groups are equal;
/// kNone
///                 = any copy will do.   Copies of a vertex are in rising order of group
/// out  primitive  same indices in number and order, vertex_count() grown; bounds unchanged
/// cost O(V' + C log(corners of a vertex))
void split_vertices(Primitive& primitive, std::span<const std::uint32_t> group);

}  // namespace sinew
