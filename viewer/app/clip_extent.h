// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"
#include "viewer/app/cache/cache_on_scene.h"
#include "viewer/app/clip_poses.h"
#include "viewer/app/pictures/outline.h"

namespace sinew::viewer {

/// Bounds of a clip over its whole duration, in world coordinates.
struct ClipExtent {
  Aabb reached;     ///< contains every sampled pose
  Outline outline;  ///< extreme points of all poses; the camera frames them

  /// Box of the pose with the longest diagonal; scales ambient occlusion, so a long walk does not enlarge its radius.
  Aabb largest;
};

/// Samples 17 poses spread evenly from start to end of the clip. Measures deformed vertices, or joints if the scene has
/// no meshes. A single point becomes a small cube; a scene without joints has empty boxes.
/// in   clip   kNone = the rest pose
///      cache  geometry cache that plays together with the clip at full weight; null = none
///      moved  layers, root motion or a graph; null = the clip alone
/// cost up to 17 evaluations
ClipExtent clip_extent(const Scene& scene, std::uint32_t clip, const CacheOnScene* cache = nullptr,
                       const MovedBy* moved = nullptr);

/// World-space box of all visible triangles of a frame. It uses deformed vertices, because a skinned mesh may be far
/// from its static box. Empty when the scene draws nothing.
/// cost O(vertices)
Aabb bounds_of(const Scene& scene, const FrameResult& frame);

}  // namespace sinew::viewer
