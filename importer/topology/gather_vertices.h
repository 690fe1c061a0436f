// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/model/mesh.h"

namespace sinew {

/// Replaces the vertices of a primitive by copies of them in another order: attributes, influences, morph deltas and
/// source_vertex. `indices`, bounds and centers of rotation are left as they are.
/// in    old_of_new[V']  each old vertex at least once; influence groups stay in their order
/// cost  O(V + V'), and for each morph target that too
void gather_vertices(Primitive& primitive, std::span<const std::uint32_t> old_of_new);

/// The same with each old vertex once; `indices` go on naming the same vertices.
void permute_vertices(Primitive& primitive, std::span<const std::uint32_t> old_of_new);

}  // namespace sinew
