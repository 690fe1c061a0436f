// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// The property tracks of an animation of the source, where the target has the same property: on a material, camera or
/// light of the same name, or on the joint that follows the other one (a property of a joint is that it is visible).
/// out  retargeted  tracks of properties, in place of those that it had
///      what is not carried, by the names of clip_channels.h; a thing without a name is described
/// cost O(tracks * things), allocates
std::vector<std::string> retarget_properties(const Animation& animation, const SkeletonMap& map, const Scene& source,
                                             const Scene& target, Animation& retargeted);

}  // namespace sinew
