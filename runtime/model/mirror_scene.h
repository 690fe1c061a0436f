// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/mirror_map.h"
#include "runtime/model/scene.h"

namespace sinew {

/// How a scene is mirrored: make_mirror_map (mirror_map.h) of its skeleton, with morph targets paired by their names
/// (side_names.h) within each mesh instance. Targets without a partner stay.
/// cost as make_mirror_map, and O(W log W)
MirrorMap make_mirror_map(const Scene& scene, const MirrorOptions& options = {});

}  // namespace sinew
