// SPDX-License-Identifier: MIT
#include "importer/rewrite/replace_keys.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "importer/read/animations.h"
#include "importer/rewrite/key_writer.h"

namespace sinew::rewrite {
namespace {

/// The keys of an animation for one target; empty if it has none.
std::optional<Keys> find_keys(const Scene& scene, const Animation& animation, const ChannelTarget& target) {
  const std::uint32_t joint = scene.skeleton.joint_of_node[target.node];
  if (target.moves_joint()) {
    for (const BoneAnimation& bone : animation.bones) {
      if (bone.joint != joint) continue;
      if (target.property == AnimatedProperty::translation) return keys_of(bone.translation);
      if (target.property == AnimatedProperty::rotation) return keys_of(bone.rotation);
      return keys_of(bone.scale);
    }
  }
  if (target.property != AnimatedProperty::weights) return std::nullopt;
  for (const WeightAnimation& animated : animation.weights) {
    const MeshInstance& instance = scene.instances[animated.instance];
    const bool whole = animated.weights.target_count == instance.rest_weights.size();
    const bool same_part = target.element == kNone ? whole : !whole && animated.first_target == target.element;
    if (instance.joint == joint && same_part) return keys_of(animated.weights);
  }
  return std::nullopt;
}

/// The target of a channel in the new file.
ChannelTarget new_target(const Scene& scene, const NewKeys& keys, ChannelTarget target) {
  if (!target.moves_joint() || keys.channels_to.empty()) return target;
  target.node = scene.skeleton.node_of_joint[keys.channels_to[scene.skeleton.joint_of_node[target.node]]];
  return target;
}

/// Sets the node of a channel, as an index or in a KHR_animation_pointer.
void set_node(Json& target, std::uint32_t node) {
  if (target["path"] != "pointer") {
    target["node"] = node;
    return;
  }
  static const std::string kNodes = "/nodes/";
  Json& pointer = target["extensions"]["KHR_animation_pointer"]["pointer"];
  std::string text = pointer.get<std::string>();
  text.replace(kNodes.size(), text.find('/', kNodes.size()) - kNodes.size(), std::to_string(node));
  pointer = text;
}

/// Redirects channels to the nodes of their new target joints, even if that duplicates the target of another channel.
void move_channels(const gltf::Document& document, const Scene& scene, const NewKeys& keys, std::uint32_t index,
                   Json& animation) {
  IssueLog discarded_log;  // the import has reported these issues
  for (std::uint32_t c = 0; c < document.animations[index].channels.size() && !keys.channels_to.empty(); ++c) {
    const auto target = read_channel_target(document, index, c, discarded_log);
    if (!target || !target->moves_joint()) continue;
    const std::uint32_t node = new_target(scene, keys, *target).node;
    if (node != target->node) set_node(animation["channels"][c]["target"], node);
  }
}

/// The channels of an animation that get new keys.
std::map<std::uint32_t, Keys> changed_channels(const gltf::Document& document, const Scene& scene, std::uint32_t index,
                                               const NewKeys& new_keys) {
  const Animation& after = new_keys.animations[index];
  IssueLog discarded_log;  // the import has reported these issues
  std::set<ChannelTarget> seen;
  std::map<std::uint32_t, Keys> changed;
  for (std::uint32_t c = 0; c < document.animations[index].channels.size(); ++c) {
    const auto target = read_channel_target(document, index, c, discarded_log);
    if (!target || !seen.insert(*target).second) continue;
    if (!target->moves_joint() && target->property != AnimatedProperty::weights) continue;
    auto keys = find_keys(scene, after, new_target(scene, new_keys, *target));
    if (keys && keys != find_keys(scene, scene.animations[index], *target)) changed.emplace(c, *std::move(keys));
  }
  return changed;
}

/// Removes samplers without any channel.
void drop_samplers(Json& animation, const std::set<std::uint32_t>& candidates) {
  std::set<std::uint32_t> used;
  for (const Json& channel : animation["channels"]) used.insert(channel["sampler"].get<std::uint32_t>());
  Json kept = Json::array();
  std::vector<std::uint32_t> to;
  for (std::uint32_t s = 0; s < animation["samplers"].size(); ++s) {
    to.push_back(static_cast<std::uint32_t>(kept.size()));
    if (used.contains(s) || !candidates.contains(s)) kept.push_back(std::move(animation["samplers"][s]));
  }
  for (Json& channel : animation["channels"]) channel["sampler"] = to[channel["sampler"].get<std::uint32_t>()];
  animation["samplers"] = std::move(kept);
}

}  // namespace

void replace_keys(const gltf::Document& document, const Scene& scene, const NewKeys& new_keys, Draft& draft) {
  for (std::uint32_t a = 0; a < new_keys.animations.size(); ++a) {
    Json& animation = list_of(draft, "animations")[a];
    KeyWriter writer(draft);
    std::set<std::uint32_t> left;
    for (auto& [channel, keys] : changed_channels(document, scene, a, new_keys)) {
      const std::uint32_t sampler = document.animations[a].channels[channel].sampler;
      Json own = animation["samplers"][sampler];
      for (const char* end : {"input", "output"})
        draft.spare_accessors.insert(static_cast<std::uint32_t>(own[end].get<double>()));
      writer.write(keys, own);
      animation["channels"][channel]["sampler"] = animation["samplers"].size();
      animation["samplers"].push_back(std::move(own));
      left.insert(sampler);
    }
    drop_samplers(animation, left);
    move_channels(document, scene, new_keys, a, animation);
    writer.finish();
  }
}

}  // namespace sinew::rewrite
