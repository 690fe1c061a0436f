// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "importer/tool/json.h"
#include "runtime/lod/compile_skeleton_lod.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// A list of the branches that a skeleton LOD leaves out. It has the uppermost joint of each branch, the number of its
/// joints, and the joint that they follow.
std::string left_out_text(const Scene& scene, const CompiledSkeletonLod& within);

/// {asked, measured, joints, left_out: [{joint, node, follows}]} with every joint that is left out. Lengths in metres.
Json left_out_json(const Scene& scene, const CompiledSkeletonLod& within);

/// One line per level: the requested limit, how many joints are left out, and the measured displacement.
std::string lod_lines(std::span<const CompiledSkeletonLod> lods, std::size_t joint_count);

}  // namespace sinew::tool
