// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/lod/clip_bounds.h"
#include "runtime/plan/frame_input.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// What nobody sees of a frame, as FrameInput takes it.
struct Unseen {
  std::vector<std::uint8_t> out_of_view;  ///< [instances]
  bool all = false;                       ///< of at least one

  friend bool operator==(const Unseen&, const Unseen&) = default;

  /// Something that is unseen here is not in `other`.
  bool hides_more_than(const Unseen& other) const noexcept;
};

/// Tells, before a pose is evaluated, which meshes cannot be in a picture: by the boxes that they never leave while
/// their clip plays, so that whoever comes into view is evaluated in that very frame.
class Sight {
 public:
  /// Must outlive the sight. The boxes of a clip are made when it is first looked at.
  Sight(const Scene& scene, const Needs& needs) : scene_(&scene), needs_(needs), reach_(scene.animations.size() + 1) {}

  /// in   clip  kNone = the rest pose;   aspect  width / height of the picture
  Unseen of(std::uint32_t clip, const View& view, double aspect);

  /// All in view.
  Unseen nothing() const { return {std::vector<std::uint8_t>(scene_->instances.size(), 0), false}; }

 private:
  const Scene* scene_;
  Needs needs_;
  std::vector<std::optional<std::vector<Aabb>>> reach_;  // [clips + 1], the last is the rest pose
};

/// Lights, and numbers of materials that clips move, matter to nobody who sees no mesh: only lines along the joints and
/// cameras on them need the joints of a character out of view. in   unseen  must outlive the input
void leave_out(const Unseen& unseen, bool joints_watched, FrameInput& input);

}  // namespace sinew::viewer
