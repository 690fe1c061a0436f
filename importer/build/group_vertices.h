// SPDX-License-Identifier: MIT
#pragma once
#include "importer/build/merge_influences.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Sorts the vertices of a primitive by their number of influences, so that skinning kernels run over whole ranges with
/// one count. Inside a group, vertices with the same influences come together where the first of them is, so that
/// kernels find whole vectors of vertices that follow one joint or one blend; else the file's order stays.
/// `source_vertex` maps back to the file; indices are renumbered.
/// in    primitive   in the file's vertex order, without morph targets
/// out   primitive   with influences, groups by rising count
/// cost  O(V + indices), expected
void group_vertices(Primitive& primitive, MergedInfluences merged);

}  // namespace sinew
