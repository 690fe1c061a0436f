// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/needs.h"

namespace sinew {

/// Boxes that hold the mesh instances at every time of a clip, known before any pose is: what is out of view by its box
/// need not be evaluated (FrameInput::out_of_view, FrameInput::asleep). They hold for a clip that plays alone, in full
/// and with its own morph weights; for the rest pose of `clip` kNone.
///
/// Every key interval is cut in pieces; a piece holds the box of each joint's vertices in its middle, grown by how far
/// they can stray within it (pose_drift.h). Linear blending stays within the boxes of the joints; the other kinds of
/// skinning bulge, they get half the box's diagonal more on each side. in   scene     finished, passed its checks;
/// needs   for their kinds of skinning and their joint detail out  [instances] in the space below FrameInput::root:
/// transform them by it (grow_bounds.h). Empty = not known, so take it for
///      in view: meshes that correctives morph, skinned meshes with parts that are not, clips of more than
///      kMaxBoundsPoses poses of joints
/// cost O(key times * J + V), allocates
std::vector<Aabb> clip_bounds(const Scene& scene, const Needs& needs, std::uint32_t clip);
inline constexpr std::size_t kMaxBoundsPoses = 4'000'000;

}  // namespace sinew
