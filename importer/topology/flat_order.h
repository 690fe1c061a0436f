// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/mesh.h"

namespace sinew {

/// Orders the vertices of a mesh with flat faces for FlatNormalsJob: of all triangles whose corners are in the same
/// three influence groups, the first corners lie in a row, and the second ones, and the third ones. So a vertex stays
/// in its group, and whole vectors of corners are read at once (FlatStream). Triangles of a stream are in the order
/// that their first corners had. The list of triangles keeps its order and winding.
/// in    primitive   each vertex is a corner of one triangle at most
/// cost  O(V log V)
void order_flat_corners(Primitive& primitive);

}  // namespace sinew
