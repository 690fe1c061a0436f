// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/lod/clip_bounds.h"
#include "runtime/plan/frame_input.h"
#include "viewer/light/environment.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// The mesh instances that are outside the view frustum.
struct CulledInstances {
  std::vector<std::uint8_t> out_of_view;  ///< [instances] 1 = out of view; format of FrameInput::out_of_view
  bool every_instance = false;            ///< true if there are instances and all are out of view

  friend bool operator==(const CulledInstances&, const CulledInstances&) = default;

  /// True if some instance is culled here but not in `other`.
  bool culls_more_than(const CulledInstances& other) const noexcept;
};

/// Culls mesh instances before the pose is evaluated, using bounds over the whole clip. A mesh never leaves these
/// bounds, so it is evaluated in the very frame in which it comes into view.
class FrustumCulling {
 public:
  /// in   scene  must outlive this. The bounds of a clip are computed at its first use.
  ///      reach  [instances] bounds of their geometry cache, added to every clip's bounds; empty = no cache
  FrustumCulling(const Scene& scene, const Needs& needs, std::vector<Aabb> reach = {})
      : scene_(&scene), needs_(needs), reach_(std::move(reach)), bounds_(scene.animations.size() + 1) {}

  /// in   clip  kNone = the rest pose;   aspect  width / height of the picture
  ///      shadow  result of shadow_sweep(): instances whose shadow may be in view are kept
  CulledInstances of(std::uint32_t clip, const View& view, double aspect,
                     const std::optional<glm::vec3>& shadow = glm::vec3(0.0f));

  /// The result that culls nothing.
  CulledInstances all_in_view() const { return {std::vector<std::uint8_t>(scene_->instances.size(), 0), false}; }

 private:
  const Scene* scene_;
  Needs needs_;
  std::vector<Aabb> reach_;
  std::vector<std::optional<std::vector<Aabb>>> bounds_;  // [clips + 1][instances]; the last entry is the rest pose
};

/// The vector along which meshes cast shadows, as long as the longest shadow. Zero if nothing casts shadows. Empty if a
/// light of the scene casts them: its direction is known only after the pose is evaluated.
/// in   reached  bounds of the clip, world space
///      environment  its key light counts where the scene has no lights; null = the default key light
std::optional<glm::vec3> shadow_sweep(const Scene& scene, bool shadows, const Aabb& reached,
                                      const Environment* environment = nullptr);

/// Writes the culling result to the frame's input. If every mesh is out of view, the whole character sleeps, lights and
/// animated materials included. `joints_needed` (skeleton lines or a camera on a joint) keeps it awake.
/// in   culled  must outlive the input
void apply_culling(const CulledInstances& culled, bool joints_needed, FrameInput& input);

}  // namespace sinew::viewer
