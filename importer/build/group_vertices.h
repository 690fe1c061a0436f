// SPDX-License-Identifier: MIT
#pragma once
#include "importer/build/merge_influences.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Sorts the vertices of a primitive by number of influences, so that skinning kernels process ranges with one count.
/// Within a group, vertices with equal joints are adjacent, and among these vertices with equal weights, so that whole
/// vectors share a blend. Such runs are split into whole multiples of 16 vertices, then 8, then 4, then the rest, so
/// that vectors start at run boundaries. Otherwise runs are in order of their first vertices. The order is idempotent.
/// `source_vertex` maps back to the file; indices are renumbered.
/// in    primitive   in file vertex order, without morph targets
/// out   primitive   with influences; groups in order of increasing count
/// cost  O(V + indices), expected
void group_vertices(Primitive& primitive, MergedInfluences merged);

}  // namespace sinew
