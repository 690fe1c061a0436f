// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew {

/// [clips][instances] Bounds of each mesh instance over the whole of each clip, computed by clip_boxes
/// (lod/clip_bounds.h) when the clips were compiled. An empty or missing list means that the bounds of that clip were
/// not computed. An empty box means that the bounds of that instance are unknown.
using ClipBoxes = std::vector<std::vector<Aabb>>;

}  // namespace sinew
