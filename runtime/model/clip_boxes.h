// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew {

/// [clips][instances] Where the mesh instances of a scene are while each clip plays, as clip_boxes (lod/clip_bounds.h)
/// found it when the clips were compiled. There may be fewer lists than clips, and an empty list says that the boxes of
/// its clip were not computed. An empty box says that nothing is known of the instance.
using ClipBoxes = std::vector<std::vector<Aabb>>;

}  // namespace sinew
