// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>

#include "viewer/app/framing.h"
#include "viewer/app/orbit_camera.h"
#include "viewer/app/shown_scene.h"

namespace sinew::viewer {

/// The user's camera on a scene that is shown. It frames what the user wants to see, and may go along with it.
class FramedCamera {
 public:
  OrbitCamera orbit;

  /// Moves without turning so that what is free of the picture is filled.
  /// cost as framed()
  void frame(Framing framing, ShownScene& shown, double aspect, const FreeWidth& free = {});

  /// Goes along with the pose after frame() of Framing::follow. Another clip is framed anew.
  void follow(ShownScene& shown, double aspect);

  /// The scene has changed. The camera stays, and where it goes along, it keeps its place beside what it goes along
  /// with.
  void go_on(ShownScene& shown);

 private:
  void go_along(Framed what, const Playback& playback);
  void move_to(const glm::dvec3& place);

  std::optional<Framed> followed_;  ///< set while the camera goes along
  std::uint32_t followed_clip_ = kNone;
  FreeWidth free_;         ///< of the last frame()
  glm::dvec3 place_{0.0};  ///< where it has gone
};

}  // namespace sinew::viewer
