// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "viewer/app/clip_extent.h"

namespace sinew::viewer {

/// The subject that the camera frames.
enum class Framing : std::uint8_t {
  clip,   ///< everything that the clip reaches
  pose,   ///< one pose only
  follow  ///< the character as if it moved in place; the camera follows it horizontally
};

/// Points that the camera frames, and the path that it follows.
struct Framed {
  Outline outline;  ///< Points to frame. Framing::follow: of all poses, each minus its path point.

  /// With Framing::follow: box centers of poses spread evenly over the clip, with y = 0. Otherwise one point, the
  /// origin.
  std::vector<glm::vec3> path{glm::vec3(0.0f)};
  double duration_s = 0.0;  ///< time span of the path; 0 = it does not move

  /// Position on the path at a time: linear between its points, clamped at both ends.
  glm::dvec3 offset_at(double time_s) const noexcept;
};

/// in   clip   kNone = the rest pose;   time_s  used by Framing::pose only
///      cache  geometry cache that plays together with the clip at full weight; null = none
/// cost one evaluation for a pose, up to 17 otherwise
Framed framed(Framing framing, const Scene& scene, std::uint32_t clip, double time_s,
              const CacheOnScene* cache = nullptr, const MovedBy* moved = nullptr);

}  // namespace sinew::viewer
