// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene_look.h"
#include "runtime/plan/run_plan.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// A camera of the file at any time, known before the pose is: a plan of its own evaluates the camera's joint and those
/// above it, and no other (SkeletonLod).
class CameraPose {
 public:
  /// in   camera  of the scene, on a joint; the scene must outlive this
  CameraPose(const Scene& scene, std::uint32_t camera);

  std::uint32_t camera() const noexcept { return camera_; }

  /// Some clip moves it, or changes what it sees.
  bool moves() const noexcept { return !plan_.moved_joints().empty() || plan_.runs(Stage::properties); }

  /// What it sees at one time of a clip, as view_of_camera (file_camera.h).
  /// in   clip  kNone = the rest pose;   bounds  of the clip
  /// cost O(joints above the camera), no allocation but for moved properties
  View at(std::uint32_t clip, double time_s, double aspect, const Aabb& bounds);

 private:
  const Scene* scene_;
  std::uint32_t camera_;
  Plan plan_;
  FrameBuffer frame_;
  SceneLook look_;
};

}  // namespace sinew::viewer
