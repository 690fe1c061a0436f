// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/model/scene.h"
#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// make_skeleton_map with reference poses chosen from the rest pose and the bind pose (model/bind_pose.h) of each body.
/// It takes the pair of poses with the smallest SkeletonMap::bone_angle_rad. The rest poses stay unless another pair
/// reduces that angle by at least half a degree and a quarter of itself. A reference pose in the options is not
/// replaced. SkeletonMap::source_reference and target_reference say which poses were chosen.
/// cost at most that of four maps, and two bind poses
SINEW_API SkeletonMap make_skeleton_map(const Scene& source, const Scene& target,
                                        const SkeletonMapOptions& options = {});

}  // namespace sinew
