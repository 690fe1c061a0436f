// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/model/scene.h"
#include "runtime/plan/needs.h"

namespace sinew {

/// Bounds of each mesh instance over all times of a clip, known before any pose is evaluated. An instance whose box is
/// out of view need not be evaluated (FrameInput::out_of_view, FrameInput::asleep). The boxes hold for a clip that
/// plays alone, at full weight and with its own morph weights. For clip kNone they hold the rest pose.
///
/// Every key interval is cut into pieces. The boxes of the joints' vertices are placed at the middle of a piece and
/// grown by how far they can move within it (pose_drift.h). Linear blending stays within the boxes of the joints. Other
/// kinds of skinning bulge: their boxes grow by half the diagonal on each side.
///
/// Boxes stored with the clip give the same result without looking at the keys. They are for all joints, so with a
/// skeleton LOD the keys are used instead.
/// in   scene  finished (scene.h) and checked;   needs  for their kinds of skinning and their skeleton LOD
///      stored[instances]  clip_boxes of this clip, from a file (read_clip_boxes); empty = none
/// out  [instances] in the space below FrameInput::root: transform them by it (grow_bounds.h). An empty box means
///      unknown, so take the instance as in view. Unknown are meshes that correctives morph, skinned meshes with parts
///      that are not skinned, and clips with more than kMaxBoundsPoses joint poses.
/// cost O(key times * J + V), with `stored` O(instances); allocates
SINEW_API std::vector<Aabb> clip_bounds(const Scene& scene, const Needs& needs, std::uint32_t clip,
                                        std::span<const Aabb> stored = {});
inline constexpr std::size_t kMaxBoundsPoses = 4'000'000;

/// Computes a box for each mesh instance from the keys of a clip, without margins for skinning, rounding and the error
/// of compression. clip_bounds adds these margins. Call it when a clip is compiled, while Scene::animations hold the
/// original keys, and store the boxes with the clip (AssetFileOptions::clip_boxes).
/// out  [instances]     cost O(key times * J + V), allocates
SINEW_API std::vector<Aabb> clip_boxes(const Scene& scene, std::uint32_t clip);

}  // namespace sinew
