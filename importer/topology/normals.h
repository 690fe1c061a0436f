// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/mesh.h"

namespace sinew {

/// What glTF asks for where triangles have no normals: every face is flat (glTF 2.0, "Meshes": "client implementations
/// MUST calculate flat normals and the provided tangents (if present) MUST be ignored"). Each corner becomes a vertex
/// of its own, tangents and morph deltas of normals and tangents go, and flat_normals is set, because morphed shapes
/// need their normals computed again (G46). eq   n = (p1 - p0) x (p2 - p0) / |...|, in double;   a face without area
/// takes +Z Points and lines are left alone.   cost O(V + 3 F)
void make_flat_normals(Primitive& primitive);

/// The normals of a rounded surface: at each place the face normals around it, each weighted by its angle there
/// (Thuermer & Wuethrich 1998), so that the result does not depend on how faces are cut into triangles. Vertices at
/// one position share their normal where faces meet along an edge, whatever their texture coordinates; parts that only
/// touch in a point, and sheets that meet at an edge of more than two faces, keep normals of their own.
/// Where one vertex has several normals it is split. Sets flat_normals = false.
/// eq   n = sum(angle_f * n_f) / |...|, in double;   a sum without length takes the first face's normal, else +Z
/// Points and lines are left alone.   cost O(F) expected
void make_smooth_normals(Primitive& primitive);

}  // namespace sinew
