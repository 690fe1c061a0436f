// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/mesh.h"

namespace sinew {

/// Orders the vertices of a flat-shaded mesh for FlatNormalsJob. Triangles whose corners are in the same three
/// influence groups form a stream. A stream stores all first corners, then all second corners, then all third corners,
/// so that whole vectors of corners are read at once (FlatStream). Vertices stay in their influence group. Triangles of
/// a stream are in the order of their first corners; the triangle list keeps its order and winding.
/// in    primitive   each vertex is a corner of at most one triangle
/// cost  O(V log V)
void order_flat_corners(Primitive& primitive);

}  // namespace sinew
