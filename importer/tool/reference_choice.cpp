// SPDX-License-Identifier: MIT
#include "importer/tool/reference_choice.h"

#include <fmt/core.h>

#include "importer/tool/clip_choice.h"
#include "importer/tool/messages.h"
#include "importer/tool/sample_times.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/model/bind_pose.h"

namespace sinew::tool {
namespace {

std::vector<Transform> pose_at(const Scene& scene, std::uint32_t clip, double time_s) {
  TruthPose pose;
  evaluate_truth(scene.animations[clip], scene.skeleton, time_s, pose);
  std::vector<Transform> local;
  for (const Transformd& t : pose.local)
    local.push_back({glm::vec3(t.translation), quat_cast<float>(normalised(t.rotation)), glm::vec3(t.scale)});
  return local;
}

}  // namespace

tl::expected<std::vector<Transform>, std::string> read_reference(const Scene& scene,
                                                                 const std::optional<std::string>& wanted) {
  if (!wanted) return std::vector<Transform>();
  if (*wanted == "rest") return scene.skeleton.rest;
  if (*wanted == "bind") return bind_pose(scene).local;
  const std::size_t at = wanted->rfind('@');
  if (at == std::string::npos)
    return tl::unexpected(fmt::format("--reference {}: is neither rest nor bind nor CLIP@SECONDS", *wanted));
  const auto clips = choose_clips(scene, wanted->substr(0, at));
  if (!clips) return tl::unexpected("--reference: " + clips.error());
  const auto times = parse_times(wanted->substr(at + 1));
  if (!times) return tl::unexpected("--reference: " + times.error());
  if (clips->front() == kNone || times->size() != 1)
    return tl::unexpected(fmt::format("--reference {}: names no frame of a clip", *wanted));
  return pose_at(scene, clips->front(), times->front());
}

std::string reference_text(PoseReference reference, const std::optional<std::string>& wanted) {
  if (wanted && *wanted != "rest" && *wanted != "bind") return *wanted;
  const bool is_bind = wanted ? *wanted == "bind" : reference == PoseReference::bind;
  return is_bind ? "bind pose" : "rest pose";
}

std::optional<std::string> bind_pose_warning(const Scene& scene) {
  constexpr double kLeast = 0.01;
  const BindPose bind = bind_pose(scene);
  if (bind.distance < kLeast * bind.size) return std::nullopt;
  const std::string& name = scene.skeleton.names[bind.joint];
  std::string text = fmt::format(
      "warning: nodes rest elsewhere than where their meshes were bound: {}, up to {:.1f} % of the body apart ({})",
      counted(bind.differs.size(), "joint"), 100.0 * bind.distance / bind.size,
      name.empty() ? fmt::format("node {}", scene.skeleton.node_of_joint[bind.joint]) : in_quotes(name));
  if (!bind.other_skins.empty())
    text += fmt::format("; {} bound in another pose than the largest one", counted(bind.other_skins.size(), "skin"));
  return text;
}

}  // namespace sinew::tool
