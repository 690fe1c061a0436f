// SPDX-License-Identifier: MIT
#pragma once
#include "importer/build/merge_influences.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Sorts the vertices of a primitive by their number of influences, so that skinning kernels run over whole ranges with
/// one count. Inside a group, vertices of the same joints come together, and of these those of the same weights, so
/// that kernels find whole vectors of vertices that follow the same joints or one blend. First come the whole multiples
/// of 16 vertices of such runs, then those of 8 and of 4 of what is left, then the rest, so that vectors of any width
/// begin where runs do; else runs stand in the order of their first vertices. Vertices in this order keep it.
/// `source_vertex` maps back to the file; indices are renumbered.
/// in    primitive   in the file's vertex order, without morph targets
/// out   primitive   with influences, groups by rising count
/// cost  O(V + indices), expected
void group_vertices(Primitive& primitive, MergedInfluences merged);

}  // namespace sinew
