// SPDX-License-Identifier: MIT
#include "importer/tool/info/node_tree.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

/// " WORD N, N" for a list of numbers; empty for an empty list.
std::string numbers(const char* word, const Json& list) {
  std::string out;
  for (const Json& number : list) out += (out.empty() ? "" : ", ") + number.dump();
  return out.empty() ? out : fmt::format("{} {}", word, out);
}

/// "mesh 0, skin 1, joint of skin 0, animated by clip 0, 2".
std::string attachments_text(const Json& node) {
  std::string out;
  const auto add = [&](const std::string& text) {
    if (!text.empty()) out += (out.empty() ? "" : ", ") + text;
  };
  for (const char* kind : {"mesh", "skin"})
    if (!node[kind].is_null()) add(fmt::format("{} {}", kind, node[kind].dump()));
  add(numbers("camera", node["cameras"]));
  add(numbers("light", node["lights"]));
  add(numbers("joint of skin", node["joint_of_skins"]));
  add(numbers("animated by clip", node["animated_by_clips"]));
  if (node["hidden"].get<bool>()) add("hidden");
  return out;
}

Json node_json(const Skeleton& skeleton, std::uint32_t joint) {
  const std::uint32_t parent = skeleton.parents[joint];
  return {{"name", skeleton.names[joint]},
          {"parent", parent == kNone ? Json() : Json(skeleton.node_of_joint[parent])},
          {"children", Json::array()},
          {"mesh", nullptr},
          {"skin", nullptr},
          {"cameras", Json::array()},
          {"lights", Json::array()},
          {"joint_of_skins", Json::array()},
          {"animated_by_clips", Json::array()},
          {"hidden", false}};
}

}  // namespace

std::set<std::uint32_t> animated_nodes(const Scene& scene, const Animation& animation) {
  std::set<std::uint32_t> joints, nodes;
  for (const BoneAnimation& bone : animation.bones)
    if (!bone.empty()) joints.insert(bone.joint);
  for (const WeightAnimation& weights : animation.weights) joints.insert(scene.instances[weights.instance].joint);
  for (const PropertyTrack& track : animation.properties)
    if (track.target.kind == PropertyKind::node_visible) joints.insert(track.target.index);
  for (const std::uint32_t joint : joints) nodes.insert(scene.skeleton.node_of_joint[joint]);
  return nodes;
}

Json node_list_json(const Scene& scene) {
  const Skeleton& skeleton = scene.skeleton;
  Json list = Json::array();
  for (const std::uint32_t joint : skeleton.joint_of_node) list.push_back(node_json(skeleton, joint));
  const auto at = [&](std::uint32_t joint) -> Json& { return list[skeleton.node_of_joint[joint]]; };
  for (std::size_t n = 0; n < list.size(); ++n)
    if (!list[n]["parent"].is_null()) list[list[n]["parent"].get<std::size_t>()]["children"].push_back(n);
  for (const MeshInstance& instance : scene.instances) {
    at(instance.joint)["mesh"] = instance.mesh;
    if (instance.skin != kNone) at(instance.joint)["skin"] = instance.skin;
  }
  for (std::size_t c = 0; c < scene.cameras.size(); ++c)
    if (scene.cameras[c].joint != kNone) at(scene.cameras[c].joint)["cameras"].push_back(c);
  for (std::size_t l = 0; l < scene.lights.size(); ++l)
    if (scene.lights[l].joint != kNone) at(scene.lights[l].joint)["lights"].push_back(l);
  for (std::size_t s = 0; s < scene.skins.size(); ++s)
    for (const std::uint32_t joint : std::set(scene.skins[s].joints.begin(), scene.skins[s].joints.end()))
      at(joint)["joint_of_skins"].push_back(s);
  for (std::size_t a = 0; a < scene.animations.size(); ++a)
    for (const std::uint32_t node : animated_nodes(scene, scene.animations[a]))
      list[node]["animated_by_clips"].push_back(a);
  for (const std::uint32_t joint : scene.hidden_joints) at(joint)["hidden"] = true;
  return list;
}

std::string node_tree_text(const Json& list) {
  constexpr std::size_t kDeepest = 30;  // levels of indentation; deeper nodes print their depth instead
  std::string out;
  std::vector<std::pair<std::size_t, std::size_t>> open;  // pairs of node and depth; the last one is next
  for (std::size_t n = list.size(); n-- > 0;)
    if (list[n]["parent"].is_null()) open.emplace_back(n, 0);
  while (!open.empty()) {
    const auto [n, depth] = open.back();
    open.pop_back();
    const Json& node = list[n];
    const std::string name = node["name"].get<std::string>(), what = attachments_text(node);
    out += fmt::format("{:{}}{}{}{}{}{}{}\n", "", 2 + 2 * std::min(depth, kDeepest),
                       depth > kDeepest ? fmt::format("(depth {}) ", depth) : "", n, name.empty() ? "" : " ",
                       name.empty() ? "" : in_quotes(name), what.empty() ? "" : ": ", what);
    const Json& children = node["children"];
    for (std::size_t c = children.size(); c-- > 0;) open.emplace_back(children[c].get<std::size_t>(), depth + 1);
  }
  return out;
}

}  // namespace sinew::tool
