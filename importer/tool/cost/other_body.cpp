// SPDX-License-Identifier: MIT
#include "importer/tool/cost/other_body.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "importer/tool/cost/true_pose.h"
#include "runtime/retarget/humanoid_bones.h"

namespace sinew::cost {
namespace {

constexpr float kBody = 0.75f, kLegs = 0.9f, kArms = 1.1f;

double lowest_foot(const Skeleton& skeleton, std::span<const std::uint32_t> feet) {
  const ModelPose model = model_pose(skeleton, rest_pose(skeleton));
  return std::min(translation_of(model[feet[0]]).y, translation_of(model[feet[1]]).y);
}

/// Moves the hips, so that the feet stand at a height.
void stand_at(double height, std::uint32_t hips, std::span<const std::uint32_t> feet, Skeleton& skeleton) {
  const ModelPose model = model_pose(skeleton, rest_pose(skeleton));
  const Vec3<double> up(0.0, height - lowest_foot(skeleton, feet), 0.0);
  const std::uint32_t parent = skeleton.parents[hips];
  const Vec3<double> local = parent == kNone ? up : glm::inverse(linear_part(model[parent])) * up;
  skeleton.rest[hips].translation += glm::vec3(local);
}

}  // namespace

std::optional<OtherBody> other_body(const Skeleton& skeleton) {
  const std::vector<std::uint32_t> bones = find_humanoid_bones(skeleton);
  const auto joint = [&](const std::string& bone) { return bones[humanoid_bone(bone)]; };
  OtherBody body{skeleton};
  const std::uint32_t hips = joint("hips");
  for (Transform& rest : body.skeleton.rest) rest.translation *= kBody;
  std::size_t side_index = 0;
  for (const std::string side : {"left", "right"}) {
    for (const char* bone : {"UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot"})
      if (joint(side + bone) == kNone || hips == kNone) return std::nullopt;
    for (const char* bone : {"LowerArm", "Hand"}) body.skeleton.rest[joint(side + bone)].translation *= kArms;
    for (const char* bone : {"LowerLeg", "Foot"}) body.skeleton.rest[joint(side + bone)].translation *= kLegs;
    body.hands[side_index] = joint(side + "Hand");
    body.feet[side_index++] = joint(side + "Foot");
  }
  stand_at(lowest_foot(skeleton, body.feet), hips, body.feet, body.skeleton);
  return body;
}

}  // namespace sinew::cost
