// SPDX-License-Identifier: MIT
#pragma once
#include "importer/build/merge_influences.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Sorts the vertices of a primitive by their number of influences, so that skinning kernels run over whole ranges with
/// one count. Inside a group the file's order stays. `source_vertex` maps back to the file; indices are renumbered.
/// in    primitive   in the file's vertex order, without morph targets
/// out   primitive   with influences, groups by rising count
/// cost  O(V + indices)
void group_vertices(Primitive& primitive, MergedInfluences merged);

}  // namespace sinew
