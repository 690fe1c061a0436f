// SPDX-License-Identifier: MIT
#include "importer/tool/convert/mirror_clips.h"

#include <fmt/core.h>

#include "importer/tool/messages.h"
#include "importer/tool/reference_choice.h"
#include "runtime/animation/mirror_animation.h"
#include "runtime/model/mirror_scene.h"

namespace sinew::tool {
namespace {

std::string summary_of(const Scene& scene, const MirrorMap& map) {
  const glm::vec3& n = map.plane_normal;
  std::string text = fmt::format("mirrored across ({:g} {:g} {:g}) at {:g}: {} of {} have partners", n.x, n.y, n.z,
                                 map.plane_offset, paired_joints(map), counted(map.joints.size(), "joint"));
  for (std::size_t i = 0; i < map.unpaired.size(); ++i) {
    const std::uint32_t joint = map.unpaired[i];
    text += i == 0 ? "; without a partner: " : ", ";
    text += scene.skeleton.names[joint].empty() ? fmt::format("node {}", scene.skeleton.node_of_joint[joint])
                                                : in_quotes(scene.skeleton.names[joint]);
  }
  return text;
}

}  // namespace

tl::expected<MirroredClips, std::string> mirror_clips(const Scene& scene, const std::optional<std::string>& reference) {
  const auto about = read_reference(scene, reference);
  if (!about) return tl::unexpected(about.error());
  MirrorOptions options;
  options.reference = *about;
  const MirrorMap map = make_mirror_map(scene, options);
  MirroredClips clips;
  for (const Animation& animation : scene.animations)
    clips.animations.push_back(mirror_animation(animation, map, scene.skeleton, scene.first_weight));
  for (const MirroredJoint& joint : map.joints) clips.channels_to.push_back(joint.source);
  clips.summary = summary_of(scene, map);
  if (reference || map.reference != PoseReference::rest)
    clips.summary += "; about the " + reference_text(map.reference, reference);
  return clips;
}

}  // namespace sinew::tool
