// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene.h"
#include "viewer/app/outline.h"

namespace sinew::viewer {

/// How much room a clip takes, in world space.
struct ClipExtent {
  Aabb reached;     ///< holds every pose
  Outline outline;  ///< of every pose: what the camera frames
  Aabb largest;  ///< of the single pose with the longest diagonal: what shading lengths follow, so that a walk across
                 ///< the world does not blur the walker's ambient occlusion
};

/// From the deformed vertices of poses spread over the clip, first and last included; from the joints when the scene
/// draws nothing. `clip` kNone = the rest pose. A single point counts as a small cube; a scene without joints has empty
/// boxes. cost up to 17 evaluations
ClipExtent clip_extent(const Scene& scene, std::uint32_t clip);

}  // namespace sinew::viewer
