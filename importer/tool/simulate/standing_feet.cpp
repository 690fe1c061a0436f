// SPDX-License-Identifier: MIT
#include "importer/tool/simulate/standing_feet.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "importer/tool/messages.h"
#include "importer/vrm.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/retarget/humanoid_bones.h"

namespace sinew::tool {
namespace {

/// Joints of the humanoid bones: those that the file names, or else those with names that are known.
std::vector<std::uint32_t> bones_of(const ImportedFile& file) {
  if (!file.vrm || file.vrm->bones.empty()) return find_humanoid_bones(file.scene.skeleton);
  std::vector<std::uint32_t> bones(kHumanoidBones.size(), kNone);
  for (const NamedBone& bone : file.vrm->bones)
    if (const std::uint32_t at = humanoid_bone(bone.name); at != kNone) bones[at] = bone.joint;
  return bones;
}

}  // namespace

tl::expected<std::unique_ptr<StandingFeet>, std::string> StandingFeet::make(const ImportedFile& file,
                                                                            GroundProfile ground) {
  const Skeleton& skeleton = file.scene.skeleton;
  const std::vector<std::uint32_t> bones = bones_of(file);
  const auto joint = [&](std::string_view name) { return bones[humanoid_bone(name)]; };
  auto out = std::make_unique<StandingFeet>();
  out->setup_.pelvis = joint("hips");
  for (const std::size_t side : {0, 1}) {
    const std::string name = side == 0 ? "left" : "right";
    const std::uint32_t hip = joint(name + "UpperLeg"), knee = joint(name + "LowerLeg"), ankle = joint(name + "Foot");
    if (out->setup_.pelvis == kNone || hip == kNone || knee == kNone || ankle == kNone)
      return tl::unexpected(
          fmt::format("it has no {} leg from hips to foot whose joints are known by their names", name));
    out->feet_[side] = foot_on_rest_ground(skeleton, hip, knee, ankle, joint(name + "Toes"));
  }
  out->setup_.feet = out->feet_;
  out->ground_ = std::move(ground);
  PoseMemory pose(skeleton.joint_count());
  for (std::size_t j = 0; j < skeleton.joint_count(); ++j) pose.span().set(j, skeleton.rest[j]);
  FeetState state;
  const ErrorCode code = check(FeetJob{.skeleton = &skeleton,
                                       .local = pose.span(),
                                       .setup = &out->setup_,
                                       .ground = out->ground_.ground(),
                                       .state = &state});
  if (code != ErrorCode::ok) return tl::unexpected(fmt::format("its feet cannot be used: {}", describe(code)));
  return out;
}

std::vector<std::uint32_t> StandingFeet::joints() const {
  std::vector<std::uint32_t> out{setup_.pelvis};
  for (const FootSetup& foot : feet_) out.insert(out.end(), {foot.hip, foot.knee, foot.ankle});
  return out;
}

void StandingFeet::run(const Skeleton& skeleton, const PoseSpan& pose, const Affined& root, double dt_s, bool starts) {
  if (starts) state_ = {};
  run_unchecked(FeetJob{.skeleton = &skeleton,
                        .local = pose,
                        .setup = &setup_,
                        .root = root,
                        .dt_s = dt_s,
                        .ground = ground_.ground(),
                        .state = &state_,
                        .results = results_});
}

}  // namespace sinew::tool
