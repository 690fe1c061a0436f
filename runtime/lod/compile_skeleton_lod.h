// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/model/scene.h"
#include "runtime/model/skeleton_lod.h"
#include "runtime/plan/needs.h"

namespace sinew {

/// Finds the most joints that poses can do without while no virtual vertex (virtual_vertices.h) is farther than
/// `tolerance_m` from where all joints together put it. A joint that is left out is held at the mean of its transforms
/// in the clips. From the roots down, a joint goes with all below it when their virtual vertices stay within the
/// tolerance at every key and at five times between each two. Joints that carry no vertices go as soon as nothing below
/// them is needed. Joints of cameras and lights stay.
///
/// Rigid meshes and linear blending keep to the tolerance up to rounding, since their vertices are means of what the
/// joints do. Other kinds of skinning turn the same matrices in other ways: for them frames with and without the joints
/// are compared vertex by vertex, and fewer joints are left out until these are within the tolerance too. All of this
/// holds for one clip that plays alone and at full weight.
/// in   scene        finished, passed its checks
///      tolerance_m  >= 0, in the file's units; 0 leaves out what stands still and what carries nothing
///      clips        that play, kNone = the rest pose; empty = all clips, or the rest pose where there are none
///      needs        for their kinds of skinning
/// out  an empty detail where every joint matters
/// cost O(key times * J), more for deep skeletons of which much can go; allocates. At most kMaxLodPoses poses of joints
///      and kMaxLodVertices vertices of frames are looked at, beyond that in even steps
CompiledSkeletonLod compile_skeleton_lod(const Scene& scene, double tolerance_m,
                                         std::span<const std::uint32_t> clips = {}, const Needs& needs = {});
inline constexpr std::size_t kMaxLodPoses = 4'000'000, kMaxLodVertices = 10'000'000;

}  // namespace sinew
