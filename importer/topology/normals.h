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

/// Makes the normals of a rounded surface: at each vertex the normals of the faces around it, weighted by their angle
/// there (Thuermer & Wuethrich 1998), so that the result does not depend on how a surface is cut into triangles.
/// Vertices at one position share a normal where their faces meet along an edge, whatever their texture coordinates.
/// Parts that touch only in a point, and sheets that meet at an edge with more than two faces, keep normals of their
/// own. A vertex that needs several normals is split. Clears flat_normals. Points and lines are left alone.
/// eq    n = sum(angle_f * n_f) / |...|, in double; where the sum is zero, the first face's normal, else +Z
/// cost  O(F) expected
void make_smooth_normals(Primitive& primitive);

}  // namespace sinew
