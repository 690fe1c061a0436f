// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "viewer/app/clip_extent.h"

namespace sinew::viewer {

/// What fills the picture.
enum class Framing : std::uint8_t {
  clip,   ///< all that the clip reaches
  pose,   ///< one pose
  follow  ///< the largest pose in place; the camera goes with it over the ground
};

/// What the camera frames, and where it goes.
struct Framed {
  Outline outline;  ///< follow: of all poses, each moved back by its place in `path`

  /// follow: middles of poses spread evenly over the clip, with y = 0; else one, at the origin
  std::vector<glm::vec3> path{glm::vec3(0.0f)};
  double duration_s = 0.0;  ///< of the path

  /// How far the camera has gone: between the points of the path on straight lines, the ends held.
  glm::dvec3 place_at(double time_s) const noexcept;
};

/// in   clip   kNone = the rest pose;   time_s  of the pose of Framing::pose
///      cache  plays beside the clip, at full weight; null = none
/// cost one evaluation for a pose, up to 17 otherwise
Framed framed(Framing framing, const Scene& scene, std::uint32_t clip, double time_s,
              const CacheOnScene* cache = nullptr);

}  // namespace sinew::viewer
