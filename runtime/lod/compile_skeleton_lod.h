// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/model/scene.h"
#include "runtime/model/skeleton_lod.h"
#include "runtime/plan/needs.h"

namespace sinew {

/// Finds the largest set of joints that poses can leave out. No virtual vertex (virtual_vertices.h) may then be farther
/// than `tolerance_m` from its place with all joints. A left-out joint is held at the mean of its transforms in the
/// clips. From the roots down, a joint is left out with all its descendants if their virtual vertices stay within the
/// tolerance. This is checked at every key and at five times between each two. Joints without vertices are left out as
/// soon as no descendant is needed. Joints of cameras and lights stay.
///
/// Rigid meshes and linear blending keep the tolerance up to rounding, since their vertices are weighted means of what
/// the joints do. For other kinds of skinning, frames with and without the joints are compared vertex by vertex. Fewer
/// joints are left out until these vertices are within the tolerance too. All of this holds for one clip that plays
/// alone at full weight.
/// in   scene        finished (scene.h) and checked
///      tolerance_m  >= 0, in the file's units; 0 leaves out joints that never move and joints that carry nothing
///      clips        that will play, kNone = the rest pose; empty = all clips, or the rest pose if there are none
///      needs        for their kinds of skinning
/// out  an empty `detail` if every joint matters
/// cost O(key times * J), more for deep skeletons that can lose many joints; allocates. At most kMaxLodPoses joint
///      poses and kMaxLodVertices vertices of frames are compared; beyond that they are thinned out evenly
SINEW_API CompiledSkeletonLod compile_skeleton_lod(const Scene& scene, double tolerance_m,
                                                   std::span<const std::uint32_t> clips = {}, const Needs& needs = {});
inline constexpr std::size_t kMaxLodPoses = 4'000'000, kMaxLodVertices = 10'000'000;

}  // namespace sinew
