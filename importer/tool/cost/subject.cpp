// SPDX-License-Identifier: MIT
#include "importer/tool/cost/subject.h"

#include <algorithm>

#include <fmt/format.h>

#include "importer/tool/model_size.h"

namespace sinew::cost {

Subject::Subject(const Scene& looked_at, std::uint32_t chosen_clip, const Effort& how_long)
    : scene(looked_at),
      clip(chosen_clip),
      size_m(tool::model_size_m(looked_at)),
      probe(looked_at, how_long.probe_points),
      effort(how_long) {}

std::string Subject::clip_name() const {
  const Animation* playing = animation();
  if (playing == nullptr) return "no clip";
  return playing->name.empty() ? fmt::format("clip {}", clip) : fmt::format("the clip \"{}\"", playing->name);
}

std::vector<ModelPose> Subject::compared_poses() const {
  const Skeleton& skeleton = scene.skeleton;
  if (animation() == nullptr) return {model_pose(skeleton, crooked_pose(skeleton))};
  constexpr int kPoses = 8;
  std::vector<ModelPose> poses;
  for (int i = 0; i < kPoses; ++i)
    poses.push_back(
        model_pose(skeleton, true_local_pose(skeleton, *animation(), (i + 0.5) / kPoses * animation()->duration_s)));
  return poses;
}

std::uint32_t busiest_clip(const Scene& scene) {
  if (scene.animations.empty()) return kNone;
  const auto busiest =
      std::max_element(scene.animations.begin(), scene.animations.end(),
                       [](const Animation& a, const Animation& b) { return a.bones.size() < b.bones.size(); });
  return static_cast<std::uint32_t>(busiest - scene.animations.begin());
}

}  // namespace sinew::cost
