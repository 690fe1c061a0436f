// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/mirror_map.h"
#include "runtime/model/scene.h"

namespace sinew {

/// The mirror map of a scene: that of its skeleton (mirror_map.h), with morph targets paired by names (side_names.h)
/// within each mesh instance. Targets without a partner do not change.
/// cost as make_mirror_map, and O(W log W)
MirrorMap make_mirror_map(const Scene& scene, const MirrorOptions& options = {});

}  // namespace sinew
