// SPDX-License-Identifier: MIT
#include "importer/rewrite/replace_keys.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "importer/read/accessor.h"
#include "importer/read/animations.h"
#include "importer/read/annotations.h"
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

/// Adds channels for joints that no channel of the file moves: constants of mirrored animations.
void add_channels(const gltf::Document& document, const Scene& scene, const NewKeys& keys, std::uint32_t index,
                  KeyWriter& writer, Json& animation) {
  if (keys.channels_to.empty()) return;
  IssueLog discarded_log;  // the import has reported these issues
  std::set<ChannelTarget> present;
  for (std::uint32_t c = 0; c < document.animations[index].channels.size(); ++c) {
    const auto target = read_channel_target(document, index, c, discarded_log);
    if (target && target->moves_joint()) present.insert(new_target(scene, keys, *target));
  }
  const auto add = [&](AnimatedProperty property, const char* path, std::uint32_t joint,
                       const std::optional<Keys>& track) {
    const std::uint32_t node = scene.skeleton.node_of_joint[joint];
    if (!track || !present.insert(ChannelTarget{property, node}).second) return;
    Json sampler = Json::object();
    writer.write(*track, sampler);
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back(std::move(sampler));
  };
  for (const BoneAnimation& bone : keys.animations[index].bones) {
    add(AnimatedProperty::translation, "translation", bone.joint, keys_of(bone.translation));
    add(AnimatedProperty::rotation, "rotation", bone.joint, keys_of(bone.rotation));
    add(AnimatedProperty::scale, "scale", bone.joint, keys_of(bone.scale));
  }
}

/// The bytes of new keys in an accessor of normalised integers, if each new value is also an old value.
/// in   before, after   keys of the channel; the accessor has the keys `before`
std::optional<StoredValues> stored_as_before(const Keys& before, const Keys& after, const Json& accessor,
                                             Draft& draft) {
  const int type = accessor["componentType"];
  if (type == 5126 || !accessor.value("normalized", false) || !accessor.contains("bufferView") ||
      accessor.contains("sparse") || before.interpolation != after.interpolation)
    return std::nullopt;
  const std::size_t per_key = before.values.size() / before.times_s.size();
  const std::size_t element = component_bytes(static_cast<gltf::ComponentType>(type)) * before.components;
  const std::size_t elements = per_key / before.components;
  const auto view = static_cast<std::uint32_t>(accessor["bufferView"].get<double>());
  const Bytes bytes = draft.bytes_of(view);
  const std::size_t step = draft.json["bufferViews"][view].value("byteStride", element);
  const std::size_t first = accessor.value("byteOffset", std::size_t{0});
  if (first + step * (before.times_s.size() * elements - 1) + element > bytes.size()) return std::nullopt;
  const auto key_of = [&](const Keys& keys, std::size_t key) {
    const auto at = keys.values.begin() + static_cast<std::ptrdiff_t>(key * per_key);
    return std::vector<float>(at, at + static_cast<std::ptrdiff_t>(per_key));
  };
  std::map<std::vector<float>, std::size_t> known;
  for (std::size_t key = 0; key < before.times_s.size(); ++key) known.emplace(key_of(before, key), key);
  StoredValues out{type, {}};
  for (std::size_t key = 0; key < after.times_s.size(); ++key) {
    const auto found = known.find(key_of(after, key));
    if (found == known.end()) return std::nullopt;
    for (std::size_t i = 0; i < elements; ++i) {
      const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(first + step * (found->second * elements + i));
      out.bytes.insert(out.bytes.end(), at, at + static_cast<std::ptrdiff_t>(element));
    }
  }
  return out;
}

/// The new keys of a channel, and its old keys. Without new keys the channel is left out.
struct ChangedKeys {
  std::optional<Keys> after, before;
};

/// True if a channel or its sampler says more than sinew knows. Such a channel is never left out.
bool has_more(const Json& channel, const Json& sampler) {
  const auto contains = [](const Json& object) { return object.contains("extras") || object.contains("extensions"); };
  return contains(channel) || channel["target"].contains("extras") || contains(sampler);
}

/// The channels of an animation that get new keys.
std::map<std::uint32_t, ChangedKeys> changed_channels(const gltf::Document& document, const Scene& scene,
                                                      std::uint32_t index, const NewKeys& new_keys,
                                                      const Json& animation) {
  const Animation& after = new_keys.animations[index];
  IssueLog discarded_log;  // the import has reported these issues
  std::set<ChannelTarget> seen;
  std::map<std::uint32_t, ChangedKeys> changed;
  for (std::uint32_t c = 0; c < document.animations[index].channels.size(); ++c) {
    const auto target = read_channel_target(document, index, c, discarded_log);
    if (!target || !seen.insert(*target).second) continue;
    if (!target->moves_joint() && target->property != AnimatedProperty::weights) continue;
    auto keys = find_keys(scene, after, new_target(scene, new_keys, *target));
    auto before = find_keys(scene, scene.animations[index], *target);
    const std::uint32_t sampler = document.animations[index].channels[c].sampler;
    const bool leave_out = !keys && before && !has_more(animation["channels"][c], animation["samplers"][sampler]);
    if (leave_out || (keys && keys != before)) changed.emplace(c, ChangedKeys{std::move(keys), std::move(before)});
  }
  return changed;
}

/// Removes channels.
void drop_channels(Json& animation, const std::set<std::uint32_t>& dropped) {
  Json kept = Json::array();
  for (std::uint32_t c = 0; c < animation["channels"].size(); ++c)
    if (!dropped.contains(c)) kept.push_back(std::move(animation["channels"][c]));
  animation["channels"] = std::move(kept);
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
  KeyWriter writer(draft);
  for (std::uint32_t a = 0; a < new_keys.animations.size(); ++a) {
    Json& animation = list_of(draft, "animations")[a];
    std::set<std::uint32_t> left, dropped;
    for (auto& [channel, keys] : changed_channels(document, scene, a, new_keys, animation)) {
      const std::uint32_t sampler = document.animations[a].channels[channel].sampler;
      Json own = animation["samplers"][sampler];
      for (const char* end : {"input", "output"})
        draft.spare_accessors.insert(static_cast<std::uint32_t>(own[end].get<double>()));
      left.insert(sampler);
      if (!keys.after) {
        dropped.insert(channel);
        continue;
      }
      std::optional<StoredValues> stored;
      if (keys.before)
        stored =
            stored_as_before(*keys.before, *keys.after,
                             draft.json["accessors"][static_cast<std::uint32_t>(own["output"].get<double>())], draft);
      writer.write(*keys.after, own, stored ? &*stored : nullptr);
      animation["channels"][channel]["sampler"] = animation["samplers"].size();
      animation["samplers"].push_back(std::move(own));
    }
    move_channels(document, scene, new_keys, a, animation);
    drop_channels(animation, dropped);
    drop_samplers(animation, left);
    add_channels(document, scene, new_keys, a, writer, animation);
    if (const Annotations& after = new_keys.animations[a].annotations; after != scene.animations[a].annotations)
      set_annotations(after, animation);
  }
  writer.finish();
}

}  // namespace sinew::rewrite
