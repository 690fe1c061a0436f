// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/mesh.h"

namespace sinew {

/// Gives every face its own flat normal, which glTF demands where triangles have no normals (glTF 2.0, "Meshes":
/// "client implementations MUST calculate flat normals and the provided tangents (if present) MUST be ignored"). Each
/// corner becomes a vertex of its own, in the order of order_flat_corners(). Tangents and the morph deltas of normals
/// and tangents are removed, and flat_normals is set, because a morphed shape needs its normals computed again (G46).
/// Points and lines are left alone.
/// eq   n = (p1 - p0) x (p2 - p0) / |...|, in double; a face without area gets +Z
/// cost O(V + 3 F)
void make_flat_normals(Primitive& primitive);

}  // namespace sinew
