// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/lod/clip_bounds.h"
#include "runtime/plan/frame_input.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// The mesh instances that cannot be in the picture.
struct CulledInstances {
  std::vector<std::uint8_t> out_of_view;  ///< [instances], as FrameInput takes it
  bool every_instance = false;            ///< there are instances, and all are out of view

  friend bool operator==(const CulledInstances&, const CulledInstances&) = default;

  /// Some instance is culled here and not in `other`.
  bool culls_more_than(const CulledInstances& other) const noexcept;
};

/// Finds the meshes that are out of view before the pose is evaluated. It tests the bounds of the whole clip: a mesh
/// never leaves them while the clip plays, so a mesh that comes into view is evaluated in that very frame.
class FrustumCulling {
 public:
  /// in   scene  must outlive this. The bounds of a clip are computed at its first use.
  ///      reach  [instances] where a geometry cache takes them beside every clip; empty = nowhere
  FrustumCulling(const Scene& scene, const Needs& needs, std::vector<Aabb> reach = {})
      : scene_(&scene), needs_(needs), reach_(std::move(reach)), bounds_(scene.animations.size() + 1) {}

  /// in   clip  kNone = the rest pose;   aspect  width / height of the picture
  ///      shadow  of shadow_way(): an instance whose shadow may be in view is not culled
  CulledInstances of(std::uint32_t clip, const View& view, double aspect,
                     const std::optional<glm::vec3>& shadow = glm::vec3(0.0f));

  /// No instance is culled.
  CulledInstances all_in_view() const { return {std::vector<std::uint8_t>(scene_->instances.size(), 0), false}; }

 private:
  const Scene* scene_;
  Needs needs_;
  std::vector<Aabb> reach_;
  std::vector<std::optional<std::vector<Aabb>>> bounds_;  // [clips + 1] of each instance; the last is the rest pose
};

/// Where the shadow of a mesh falls: along this vector, at most as far as it is long. Zero where nothing casts shadows;
/// nothing where the direction is known with the pose only, because the light is one of the scene.
/// in   reached  by the scene, world space
std::optional<glm::vec3> shadow_way(const Scene& scene, bool shadows, const Aabb& reached);

/// Tells the frame what to leave out. With every mesh out of view the whole character sleeps: its lights and animated
/// materials do not matter then. Its joints do while skeleton lines or a camera on a joint are shown (joints_watched).
/// in   culled  must outlive the input
void leave_out(const CulledInstances& culled, bool joints_watched, FrameInput& input);

}  // namespace sinew::viewer
