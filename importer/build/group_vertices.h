// SPDX-License-Identifier: MIT
#pragma once
#include "importer/build/merge_influences.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Reorders the vertices of a primitive by influence count, so that each skinning kernel runs over whole ranges. Within
/// a group the file's order stays; source_vertex keeps the way back, indices follow.
/// in   primitive   in the file's vertex order, without morph targets
/// out  primitive   with influences, groups by rising count.   cost O(V + indices)
void group_vertices(Primitive& primitive, MergedInfluences merged);

}  // namespace sinew
