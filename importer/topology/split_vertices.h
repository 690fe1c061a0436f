// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/assets/mesh.h"

namespace sinew {

/// Gives corners of one vertex their own copies of it, where an attribute must differ between faces.
/// Copies of a vertex lie next to each other in the old order, so influence groups stay whole; attributes, influences,
/// morph deltas and source_vertex go with each copy, and a vertex without any corner is kept once.
/// in   variant[C]  per corner (entry of `indices`): which copy of its vertex the corner takes; counted from 0 per vertex
/// out  primitive   same indices in number and order, vertex_count() grown; bounds unchanged
/// cost O(V' + C)
void split_vertices(Primitive& primitive, std::span<const std::uint32_t> variant);

}  // namespace sinew
