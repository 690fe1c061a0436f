// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/mirror_map.h"
#include "runtime/animation/pose_reference.h"
#include "runtime/base/api.h"
#include "runtime/model/scene.h"

namespace sinew {

/// The more symmetric of two poses of a scene.
struct MirrorReference {
  PoseReference pose = PoseReference::rest;
  std::vector<Transform> local;                       ///< [J] local transforms of the chosen pose
  double rest_asymmetry = 0.0, bind_asymmetry = 0.0;  ///< 0 if both poses agree
};

/// Chooses the reference pose for mirroring. It is the rest pose if that is asymmetric by at most 0.1 % of the size.
/// Otherwise it is the bind pose (bind_pose.h), if that is less than half as asymmetric, or else the rest pose.
/// Asymmetry is the mean distance of joints from the mirror image of their partner, relative to the size of the
/// skeleton.
/// cost as make_mirror_map, twice
SINEW_API MirrorReference mirror_reference(const Scene& scene, const MirrorOptions& options = {});

/// The mirror map of a scene: that of its skeleton (mirror_map.h), with morph targets paired by names (side_names.h)
/// within each mesh instance. Targets without a partner do not change. Without a reference pose in the options,
/// mirror_reference chooses it; MirrorMap::reference says which it is.
/// cost as make_mirror_map, and O(W log W)
SINEW_API MirrorMap make_mirror_map(const Scene& scene, const MirrorOptions& options = {});

}  // namespace sinew
