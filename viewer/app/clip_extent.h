// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"
#include "viewer/app/cache/cache_on_scene.h"
#include "viewer/app/outline.h"

namespace sinew::viewer {

/// The space that a clip takes, in world coordinates.
struct ClipExtent {
  Aabb reached;     ///< contains every pose
  Outline outline;  ///< of all poses: the camera frames it
  Aabb largest;     ///< of the pose with the longest diagonal. Lengths of ambient occlusion follow it, so that they do
                    ///< not grow when a character walks far
};

/// Measured on the deformed vertices of 17 poses spread over the clip, the first and the last included, or on the
/// joints when the scene draws nothing. A single point counts as a small cube; a scene without joints has empty boxes.
/// in   clip   kNone = the rest pose
///      cache  plays beside the clip, at full weight; null = none
/// cost up to 17 evaluations
ClipExtent clip_extent(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache = nullptr);

/// World-space box of everything that the frame draws, from the deformed vertices, because a skinned mesh may be far
/// from its static box. Empty when the scene draws nothing.
/// cost O(vertices)
Aabb bounds_of(const Scene& scene, const FrameResult& frame);

}  // namespace sinew::viewer
