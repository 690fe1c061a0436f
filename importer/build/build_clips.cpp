// SPDX-License-Identifier: MIT
#include "importer/build/build_clips.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <utility>

#include "importer/file/json_pointer.h"
#include "importer/read/animations.h"
#include "importer/read/rotations.h"

namespace sinew {
namespace {

/// Larger than what normalised bytes and shorts lose.
constexpr double kUnitTolerance = 0.00769;

Vec3Track vec3_track(SamplerData data) {
  Vec3Track track{data.interpolation, std::move(data.times_s), std::vector<glm::vec3>(data.values.size() / 3)};
  if (!track.values.empty()) std::memcpy(track.values.data(), data.values.data(), track.values.size() * sizeof(glm::vec3));
  return track;
}

/// Linear and step keys become unit quaternions (G18, G52). Cubic ones stay as stored: they shape the curve together
/// with their tangents, and the sampled result is normalised (G04, G05).
QuatTrack quat_track(SamplerData data, const std::string& place, IssueLog& log) {
  QuatTrack track{data.interpolation, std::move(data.times_s), {}};
  track.values.reserve(data.values.size() / 4);
  const bool cubic = data.interpolation == Interpolation::cubic_spline;
  double worst = 1.0;
  std::size_t zeros = 0;
  for (std::size_t i = 0; i + 3 < data.values.size(); i += 4) {
    const float* q = data.values.data() + i;
    const UnitRotation unit = unit_rotation(q[0], q[1], q[2], q[3]);
    const bool is_value = !cubic || i / 4 % 3 == 1;
    if (is_value && unit.length <= 1e-12) ++zeros;
    else if (is_value && std::abs(unit.length - 1.0) > std::abs(worst - 1.0)) worst = unit.length;
    track.values.push_back(cubic ? quat_xyzw(q[0], q[1], q[2], q[3]) : unit.rotation);
  }
  if (zeros > 0) log.report(Rule::rotation_zero, place, std::to_string(zeros) + " rotation keys have no length; taken as no rotation");
  if (std::abs(worst - 1.0) > kUnitTolerance)
    log.report(Rule::rotation_length, place, "a rotation key has length " + std::to_string(worst) + "; normalised");
  return track;
}

class ClipBuilder {
 public:
  ClipBuilder(const gltf::Document& document, const JointOrder& order, const Instances& instances, IssueLog& log)
      : document_(document), order_(order), instances_(instances), log_(log) {}

  Animation build(std::uint32_t animation) {
    index_ = animation;
    out_ = {};
    bones_.clear();
    weights_.clear();
    targets_.clear();
    out_.name = document_.animations[animation].name;
    for (std::uint32_t c = 0; c < document_.animations[animation].channels.size(); ++c) add_channel(c);
    for (auto& [joint, bone] : bones_) out_.bones.push_back(std::move(bone));
    for (auto& [instance, track] : weights_) out_.weights.push_back({instance, std::move(track)});
    return std::move(out_);
  }

 private:
  void add_channel(std::uint32_t channel) {
    const auto target = read_channel_target(document_, index_, channel, log_);
    if (!target) return;
    const std::string place = pointer("animations", index_, "channels", channel, "target");
    const auto key = std::pair(target->property, target->node);
    if (!targets_.emplace(key, channel).second)
      return log_.report(Rule::animation_duplicate, place, "channel " + std::to_string(targets_[key]) + " has the same target; this one is ignored");
    if (target->property == AnimatedProperty::weights)
      add_weights(*target, channel, place);
    else
      add_bone(*target, channel);
  }

  std::optional<SamplerData> read(std::uint32_t channel, AnimatedProperty property, std::uint32_t components) {
    const std::uint32_t sampler = document_.animations[index_].channels[channel].sampler;
    auto data = read_sampler(document_, index_, sampler, property, components, log_);
    if (data) out_.duration_s = std::max(out_.duration_s, static_cast<double>(data->times_s.back()));
    return data;
  }

  void add_bone(const ChannelTarget& target, std::uint32_t channel) {
    auto data = read(channel, target.property, target.property == AnimatedProperty::rotation ? 4 : 3);
    if (!data) return;
    const std::uint32_t joint = order_.joint_of_node[target.node];
    BoneAnimation& bone = bones_[joint];
    bone.joint = joint;
    switch (target.property) {
      case AnimatedProperty::translation: bone.translation = vec3_track(std::move(*data)); break;
      case AnimatedProperty::rotation: bone.rotation = quat_track(std::move(*data), pointer("animations", index_, "channels", channel, "sampler"), log_); break;
      case AnimatedProperty::scale: bone.scale = vec3_track(std::move(*data)); break;
      case AnimatedProperty::weights: break;
    }
  }

  void add_weights(const ChannelTarget& target, std::uint32_t channel, const std::string& place) {
    const std::uint32_t instance = instances_.of_node[target.node];
    const std::size_t count = instance == kNone ? 0 : instances_.list[instance].rest_weights.size();
    if (count == 0) return log_.report(Rule::animation_no_morphs, place, "the node has no mesh with morph targets; the channel is ignored");
    auto data = read(channel, AnimatedProperty::weights, static_cast<std::uint32_t>(count));
    if (!data) return;
    weights_[instance] = WeightTrack{data->interpolation, std::move(data->times_s), std::move(data->values), static_cast<std::uint32_t>(count)};
  }

  const gltf::Document& document_;
  const JointOrder& order_;
  const Instances& instances_;
  IssueLog& log_;
  std::uint32_t index_ = 0;
  Animation out_;
  std::map<std::uint32_t, BoneAnimation> bones_;
  std::map<std::uint32_t, WeightTrack> weights_;
  std::map<std::pair<AnimatedProperty, std::uint32_t>, std::uint32_t> targets_;  ///< and the channel that has it
};

}  // namespace

std::vector<Animation> build_clips(const gltf::Document& document, const JointOrder& order, const Instances& instances,
                                   IssueLog& log) {
  std::vector<Animation> animations;
  animations.reserve(document.animations.size());
  ClipBuilder builder(document, order, instances, log);
  for (std::uint32_t a = 0; a < document.animations.size(); ++a) animations.push_back(builder.build(a));
  return animations;
}

}  // namespace sinew
