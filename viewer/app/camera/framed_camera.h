// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>

#include "viewer/app/camera/framing.h"
#include "viewer/app/camera/orbit_camera.h"
#include "viewer/app/shown_scene.h"

namespace sinew::viewer {

/// A camera with the field of view of the options or the scene. It looks from the right at the side that the model
/// faces, and frames nothing yet.
OrbitCamera opening_camera(const LoadedScene& loaded, const Options& options) noexcept;

/// The user's orbit camera. It frames the chosen subject and can follow a moving character.
class FramedCamera {
 public:
  OrbitCamera orbit;

  /// Moves, without turning, so that the subject fills the part of the picture that the panel leaves free.
  /// cost as framed()
  void frame(Framing framing, ShownScene& shown, double aspect, const FreePart& free = {});

  /// After frame() with Framing::follow: moves with the current pose. If the clip has changed, frames it again.
  void follow(ShownScene& shown, double aspect);

  /// Call after the scene was replaced. The camera stays put; if it follows, it keeps its offset from the followed
  /// character.
  void keep_following(ShownScene& shown);

 private:
  void follow_from(Framed what, const Playback& playback);
  void move_to(const glm::dvec3& place);

  std::optional<Framed> followed_;  ///< set while the camera follows
  std::uint32_t followed_clip_ = kNone;
  FreePart free_;          ///< argument of the last frame()
  glm::dvec3 place_{0.0};  ///< how far the camera has followed so far
};

}  // namespace sinew::viewer
