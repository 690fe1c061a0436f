// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/model/scene.h"
#include "runtime/plan/needs.h"
#include "runtime/plan/skeleton_lod.h"

namespace sinew {

/// A detail, and how far it was seen to move vertices.
struct CompiledSkeletonLod {
  SkeletonLod detail;
  std::uint32_t left_out = 0;  ///< joints
  double measured_m = 0.0;     ///< largest displacement of the virtual vertices of joints left out, and of vertices in
                               ///< frames where these were looked at
  std::uint32_t worst_joint = kNone;  ///< whose virtual vertices moved most
};

/// The most joints that poses can do without while no virtual vertex (virtual_vertices.h) is farther than `tolerance_m`
/// from where all joints together put it. Each joint that is left out holds the mean of what the clips do with it. From
/// the roots down, a joint goes with all below it when their vertices stay within the tolerance at every key and five
/// times between each two; joints that carry no vertices go as soon as nothing below them needs them. Cameras and
/// lights keep their joints.
///
/// Rigid meshes and linear blending keep to that beyond rounding, since vertices are means of what their joints do. The
/// other kinds of skinning turn the same matrices in other ways: there frames with and without the joints are compared
/// vertex by vertex, and less is left out until these are within the tolerance too. All for one clip that plays alone
/// and in full. in   scene        finished, passed its checks
///      tolerance_m  >= 0, in the file's units; 0 leaves out what stands still and what carries nothing
///      clips        that play, kNone = the rest pose; empty = all clips, or the rest pose where there are none
///      needs        for their kinds of skinning
/// out  nothing left out (an empty detail) where every joint matters
/// cost O(key times * J) and more for deep skeletons of which much can go; more than kMaxLodPoses poses of joints are
/// looked
///      at in even steps, and so are more than kMaxLodVertices vertices of frames. Allocates
CompiledSkeletonLod compile_skeleton_lod(const Scene& scene, double tolerance_m,
                                         std::span<const std::uint32_t> clips = {}, const Needs& needs = {});
inline constexpr std::size_t kMaxLodPoses = 4'000'000, kMaxLodVertices = 10'000'000;

}  // namespace sinew
