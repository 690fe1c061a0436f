// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/model/scene.h"
#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// Copies the property tracks of an animation to the properties that the target also has. Materials, cameras and lights
/// are found by name; joints by the skeleton map (the only property of a joint is its visibility).
/// out  retargeted  its property tracks are replaced
///      returns the properties that were not copied, named as in clip_channels.h; nameless things are described
/// cost O(tracks * things), allocates
SINEW_API std::vector<std::string> retarget_properties(const Animation& animation, const SkeletonMap& map,
                                                       const Scene& source, const Scene& target, Animation& retargeted);

}  // namespace sinew
