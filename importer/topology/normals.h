// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/mesh.h"

namespace sinew {

/// Makes flat normals, as glTF requires for triangles without normals (glTF 2.0, "Meshes"). Each corner becomes its own
/// vertex, in the order of order_flat_corners(). Removes tangents and the morph deltas of normals and tangents, which
/// glTF says to ignore. Sets flat_normals, because a deformed shape needs its normals recomputed. Does not change
/// points and lines.
/// eq   n = (p1 - p0) x (p2 - p0) / |...|, in double; a degenerate face gets +Z
/// cost O(V + 3 F)
void make_flat_normals(Primitive& primitive);

}  // namespace sinew
