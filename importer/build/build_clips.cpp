// SPDX-License-Identifier: MIT
#include "importer/build/build_clips.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <utility>

#include "importer/file/json_pointer.h"
#include "importer/read/animations.h"
#include "importer/read/annotations.h"
#include "importer/read/rotations.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

Vec3Track vec3_track(SamplerData data) {
  Vec3Track track{data.interpolation, std::move(data.times_s), std::vector<glm::vec3>(data.values.size() / 3)};
  if (!track.values.empty())
    std::memcpy(track.values.data(), data.values.data(), track.values.size() * sizeof(glm::vec3));
  return track;
}

/// Builds a rotation track. Linear and step keys are normalised. Cubic keys stay as stored, because they shape the
/// curve together with their tangents; sampling normalises the result. Only cubic values that are zero, or whose square
/// overflows or underflows float, are normalised, too.
QuatTrack quat_track(SamplerData data, RotationTally& tally) {
  QuatTrack track{data.interpolation, std::move(data.times_s), {}};
  track.values.reserve(data.values.size() / 4);
  const bool cubic = data.interpolation == Interpolation::cubic_spline;
  for (std::size_t i = 0; i + 3 < data.values.size(); i += 4) {
    const float* q = data.values.data() + i;
    const UnitRotation unit = unit_rotation(q[0], q[1], q[2], q[3]);
    const bool is_value = !cubic || i / 4 % 3 == 1;
    if (is_value) tally.add(unit.length);
    const glm::quat stored = quat_xyzw(q[0], q[1], q[2], q[3]);
    const bool stays = cubic && (!is_value || is_safe_square(square_of(stored)));
    track.values.push_back(stays ? stored : unit.rotation);
  }
  return track;
}

class ClipBuilder {
 public:
  ClipBuilder(const gltf::Document& document, const JointOrder& order, const Instances& instances,
              const Placements& placements, const ImportOptions& options, IssueLog& log)
      : document_(document),
        order_(order),
        instances_(instances),
        placements_(placements),
        options_(options),
        log_(log) {}

  Animation build(std::uint32_t animation) {
    index_ = animation;
    out_ = {};
    bones_.clear();
    weights_.clear();
    properties_.clear();
    targets_.clear();
    out_.name = document_.animations[animation].name;
    for (std::uint32_t c = 0; c < document_.animations[animation].channels.size(); ++c) add_channel(c);
    for (const auto& [target, channel] : targets_)
      if (target.property == AnimatedProperty::mesh_weights && options_.animate_default_weights)
        add_mesh_weights(target, channel);
    for (auto& [joint, bone] : bones_) out_.bones.push_back(std::move(bone));
    for (auto& [first, track] : weights_) out_.weights.push_back({first.first, std::move(track), first.second});
    for (auto& [target, track] : properties_) out_.properties.push_back({target, std::move(track)});
    out_.annotations = read_annotations(document_.animations[animation].extras,
                                        pointer("animations", animation, "extras"), out_.duration_s, log_);
    return std::move(out_);
  }

 private:
  void add_channel(std::uint32_t channel) {
    const auto target = read_channel_target(document_, index_, channel, log_);
    if (!target) return;
    if (const auto other = taken_by(*target))
      return log_.report(Rule::animation_duplicate, place_of(channel),
                         "channel " + std::to_string(*other) + " has the same target; this one is ignored");
    targets_.emplace(*target, channel);
    switch (target->property) {
      case AnimatedProperty::translation:
      case AnimatedProperty::rotation:
      case AnimatedProperty::scale: return add_bone(*target, channel);
      case AnimatedProperty::weights: return add_weights(*target, instances_.of_node[target->node], channel);
      case AnimatedProperty::pointed: return add_property(*target, channel);
      case AnimatedProperty::mesh_weights: return;  // handled later: node weights take precedence over mesh weights
    }
  }

  std::string place_of(std::uint32_t channel) const {
    return pointer("animations", index_, "channels", channel, "target");
  }

  /// An earlier channel whose target overlaps this one: the same target, a part of it, or the whole that contains it.
  std::optional<std::uint32_t> taken_by(ChannelTarget target) const {
    const auto channel_of = [&](const ChannelTarget& t) -> std::optional<std::uint32_t> {
      const auto found = targets_.find(t);
      return found == targets_.end() ? std::nullopt : std::optional(found->second);
    };
    if (const auto same = channel_of(target)) return same;
    if (!target.moves_weights()) return std::nullopt;
    const bool whole = target.element == kNone;
    target.element = whole ? 0 : kNone;
    if (!whole) return channel_of(target);
    const auto part = targets_.lower_bound(target);
    if (part == targets_.end() || part->first.property != target.property || part->first.node != target.node)
      return std::nullopt;
    return part->second;
  }

  std::optional<SamplerData> read(std::uint32_t channel, const ChannelTarget& target, std::uint32_t components) {
    const std::uint32_t sampler = document_.animations[index_].channels[channel].sampler;
    return read_sampler(document_, index_, sampler, target, components, log_);
  }

  /// Extends the clip's duration. Not called for ignored channels.
  void lengthen(const SamplerData& data) {
    out_.duration_s = std::max(out_.duration_s, static_cast<double>(data.times_s.back()));
  }

  void add_bone(const ChannelTarget& target, std::uint32_t channel) {
    auto data = read(channel, target, target.property == AnimatedProperty::rotation ? 4 : 3);
    if (!data) return;
    lengthen(*data);
    const std::uint32_t joint = order_.joint_of_node[target.node];
    BoneAnimation& bone = bones_[joint];
    bone.joint = joint;
    if (target.property == AnimatedProperty::translation) bone.translation = vec3_track(std::move(*data));
    if (target.property == AnimatedProperty::rotation) {
      RotationTally tally;
      bone.rotation = quat_track(std::move(*data), tally);
      if (tally.has_issues())
        tally.report(pointer("animations", index_, "channels", channel, "sampler"), "a rotation key", "rotation keys",
                     log_);
    }
    if (target.property == AnimatedProperty::scale) bone.scale = vec3_track(std::move(*data));
  }

  static WeightTrack number_track(SamplerData data, std::uint32_t components) {
    return {data.interpolation, std::move(data.times_s), std::move(data.values), components};
  }

  void add_weights(const ChannelTarget& target, std::uint32_t instance, std::uint32_t channel) {
    const std::size_t count = instance == kNone ? 0 : instances_.list[instance].rest_weights.size();
    if (count == 0)
      return log_.report(Rule::animation_no_morphs, place_of(channel),
                         "the node has no mesh with morph targets; the channel is ignored");
    const bool whole = target.element == kNone;
    if (!whole && target.element >= count)
      return log_.report(Rule::animation_pointer, place_of(channel),
                         "there are " + std::to_string(count) + " weights, none of them is " +
                             std::to_string(target.element) + "; the channel is ignored");
    const std::uint32_t components = whole ? static_cast<std::uint32_t>(count) : 1;
    auto data = read(channel, target, components);
    if (!data) return;
    lengthen(*data);
    weights_[{instance, whole ? 0 : target.element}] = number_track(std::move(*data), components);
  }

  /// Applies a channel of mesh.weights to all nodes that show the mesh and neither have nor animate their own weights.
  void add_mesh_weights(const ChannelTarget& target, std::uint32_t channel) {
    for (std::uint32_t n = 0; n < document_.nodes.size(); ++n) {
      const gltf::Node& node = document_.nodes[n];
      if (static_cast<std::uint32_t>(node.mesh) != target.node || !node.weights.empty()) continue;
      const ChannelTarget own{AnimatedProperty::weights, n, target.element};
      if (!taken_by(own)) add_weights(target, instances_.of_node[n], channel);
    }
  }

  void add_property(const ChannelTarget& target, std::uint32_t channel) {
    const std::uint32_t components = component_count(target.pointed.kind);
    const auto data = read(channel, target, components);
    if (!data) return;
    const auto indices = placements_.indices_in_scene(target.pointed, order_);
    if (indices.empty())
      return log_.report(Rule::animation_pointer, place_of(channel),
                         "no node shows what it moves; the channel is ignored");
    lengthen(*data);
    for (const std::uint32_t index : indices)
      properties_[{target.pointed.kind, index, target.pointed.slot}] = number_track(*data, components);
  }

  const gltf::Document& document_;
  const JointOrder& order_;
  const Instances& instances_;
  const Placements& placements_;
  const ImportOptions& options_;
  IssueLog& log_;
  std::uint32_t index_ = 0;
  Animation out_;
  std::map<std::uint32_t, BoneAnimation> bones_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, WeightTrack> weights_;  ///< key: instance, first target
  std::map<PropertyTarget, WeightTrack> properties_;
  std::map<ChannelTarget, std::uint32_t> targets_;  ///< target -> the channel that animates it
};

}  // namespace

std::vector<Animation> build_clips(const gltf::Document& document, const JointOrder& order, const Instances& instances,
                                   const Placements& placements, const ImportOptions& options, IssueLog& log) {
  std::vector<Animation> animations;
  animations.reserve(document.animations.size());
  ClipBuilder builder(document, order, instances, placements, options, log);
  for (std::uint32_t a = 0; a < document.animations.size(); ++a) animations.push_back(builder.build(a));
  return animations;
}

}  // namespace sinew
