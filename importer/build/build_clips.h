// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/build/build_instances.h"
#include "importer/build/build_placements.h"
#include "importer/build/joint_order.h"
#include "importer/import_gltf.h"
#include "importer/issue_log.h"
#include "runtime/animation/bone_animation.h"

namespace sinew {

/// Builds the animations in authoring form, with the keys of the file. If the targets of two channels of an animation
/// are equal or overlap, the first channel wins.
/// err      as read_channel_target and read_sampler
/// warning  also animation-extras, animation-duplicate, animation-no-morphs, animation-pointer, rotation-length, rotation-zero
std::vector<Animation> build_clips(const gltf::Document& document, const JointOrder& order, const Instances& instances,
                                   const Placements& placements, const ImportOptions& options, IssueLog& log);

}  // namespace sinew
