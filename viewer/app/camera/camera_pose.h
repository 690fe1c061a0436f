// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene_look.h"
#include "runtime/plan/run_plan.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// Computes the view of one of the file's cameras at any clip time, before the frame's full pose is evaluated. It has
/// its own plan, whose skeleton LOD keeps only the camera's joint and the joints above it.
class CameraPose {
 public:
  /// in   camera  index in scene.cameras; must be attached to a joint. The scene must outlive this object
  CameraPose(const Scene& scene, std::uint32_t camera);

  std::uint32_t camera() const noexcept { return camera_; }

  /// True if any clip animates the camera's properties, its joint or an ancestor of that joint.
  bool moves() const noexcept { return !plan_.moved_joints().empty() || plan_.runs(Stage::properties); }

  /// Evaluates the camera at one time of a clip and converts it with view_of_camera (file_camera.h).
  /// in   clip  kNone = the rest pose;   bounds  of the clip
  /// cost O(ancestors of the camera's joint); allocates only if clips animate material or camera properties
  View at(std::uint32_t clip, double time_s, double aspect, const Aabb& bounds);

 private:
  const Scene* scene_;
  std::uint32_t camera_;
  Plan plan_;
  FrameBuffer frame_;
  SceneLook look_;
};

}  // namespace sinew::viewer
