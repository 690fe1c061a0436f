// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/needs.h"

namespace sinew {

/// Bounds of the mesh instances over all times of a clip, known before any pose is. An instance whose box is out of
/// view need not be evaluated (FrameInput::out_of_view, FrameInput::asleep). The boxes hold for a clip that plays
/// alone, at full weight and with its own morph weights; for clip kNone they hold the rest pose.
///
/// Every key interval is cut in pieces. A piece has the box of each joint's vertices at its middle, grown by how far
/// they can stray within the piece (pose_drift.h). Linear blending stays within the boxes of the joints. The other
/// kinds of skinning bulge: their boxes get half the diagonal more on each side.
///
/// Boxes that were stored with the clip are taken in place of its keys, with the same result. They are of all joints:
/// with a skeleton LOD the keys are looked at.
/// in   scene  finished, passed its checks;   needs  for their kinds of skinning and their skeleton LOD
///      stored[instances]  clip_boxes of this clip, of a file (read_clip_boxes); empty = none
/// out  [instances] in the space below FrameInput::root: transform them by it (grow_bounds.h). An empty box says that
///      nothing is known, so take the instance for in view: meshes that correctives morph, skinned meshes with parts
///      that are not skinned, clips of more than kMaxBoundsPoses poses of joints
/// cost O(key times * J + V), with `stored` O(instances); allocates
std::vector<Aabb> clip_bounds(const Scene& scene, const Needs& needs, std::uint32_t clip,
                              std::span<const Aabb> stored = {});
inline constexpr std::size_t kMaxBoundsPoses = 4'000'000;

/// What clip_bounds finds in the keys, before it adds what the kind of skinning, rounding and the error of the clip
/// call for: a list of ClipBoxes. Compute it when a clip is compiled, while `animations` are the truth, and store it
/// with the clip (AssetFileOptions::clip_boxes).
/// out  [instances]     cost O(key times * J + V), allocates
std::vector<Aabb> clip_boxes(const Scene& scene, std::uint32_t clip);

}  // namespace sinew
