// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene_look.h"
#include "runtime/plan/run_plan.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// The view of a camera of the file at any time, before the pose of the frame is evaluated. It has its own plan, whose
/// skeleton LOD keeps only the camera's joint and the joints above it.
class CameraPose {
 public:
  /// in   camera  of the scene, on a joint; the scene must outlive this
  CameraPose(const Scene& scene, std::uint32_t camera);

  std::uint32_t camera() const noexcept { return camera_; }

  /// Some clip animates the camera, its joint or a joint above.
  bool moves() const noexcept { return !plan_.moved_joints().empty() || plan_.runs(Stage::properties); }

  /// The view at one time of a clip, as view_of_camera (file_camera.h) makes it.
  /// in   clip  kNone = the rest pose;   bounds  of the clip
  /// cost O(joints above the camera); allocates only where clips animate properties
  View at(std::uint32_t clip, double time_s, double aspect, const Aabb& bounds);

 private:
  const Scene* scene_;
  std::uint32_t camera_;
  Plan plan_;
  FrameBuffer frame_;
  SceneLook look_;
};

}  // namespace sinew::viewer
