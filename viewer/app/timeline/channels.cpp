// SPDX-License-Identifier: MIT
#include "viewer/app/timeline/channels.h"

#include <algorithm>

#include <glm/trigonometric.hpp>

#include "runtime/library/clip_channels.h"
#include "runtime/math/euler.h"

namespace sinew::viewer {
namespace {

const BoneAnimation* bone_of(const Animation& animation, std::uint32_t joint) {
  for (const BoneAnimation& bone : animation.bones)
    if (bone.joint == joint) return &bone;
  return nullptr;
}

std::string name_or_number(std::string_view name, const char* kind, std::uint32_t number) {
  return name.empty() ? kind + std::to_string(number) : std::string(name);
}

}  // namespace

std::vector<Channel> channels_of(const Scene& scene, std::uint32_t clip) {
  std::vector<Channel> channels;
  if (clip >= scene.animations.size()) return channels;
  const Animation& animation = scene.animations[clip];
  const auto add = [&](ChannelKind kind, std::uint32_t owner, const auto& track) {
    if (!track.times_s.empty()) channels.push_back({kind, owner, track.times_s});
  };
  for (const BoneAnimation& bone : animation.bones) {
    add(ChannelKind::position, bone.joint, bone.translation);
    add(ChannelKind::rotation, bone.joint, bone.rotation);
    add(ChannelKind::scale, bone.joint, bone.scale);
  }
  for (const WeightAnimation& weights : animation.weights)
    add(ChannelKind::morph_weights, weights.instance, weights.weights);
  for (std::uint32_t p = 0; p < animation.properties.size(); ++p)
    add(ChannelKind::property, p, animation.properties[p].values);
  return channels;
}

std::string joint_label(const Scene& scene, std::uint32_t joint) {
  return name_or_number(
      joint < scene.skeleton.names.size() ? std::string_view(scene.skeleton.names[joint]) : std::string_view(),
      "joint ", joint);
}

std::string channel_label(const Scene& scene, std::uint32_t clip, const Channel& channel) {
  switch (channel.kind) {
    case ChannelKind::position: return joint_label(scene, channel.owner) + " position";
    case ChannelKind::rotation: return joint_label(scene, channel.owner) + " rotation";
    case ChannelKind::scale: return joint_label(scene, channel.owner) + " scale";
    case ChannelKind::property:
      return name_or_number(property_name(scene, scene.animations[clip].properties[channel.owner].target), "property ",
                            channel.owner);
    case ChannelKind::morph_weights: break;
  }
  return name_or_number(scene.meshes[scene.instances[channel.owner].mesh].name, "mesh ", channel.owner) +
         " morph targets";
}

glm::dvec3 curve_value(const Scene& scene, std::uint32_t clip, std::uint32_t joint, ChannelKind kind, double time_s) {
  const Transform& at_rest = scene.skeleton.rest[joint];
  const Transformd rest{glm::dvec3(at_rest.translation), quat_cast<double>(at_rest.rotation),
                        glm::dvec3(at_rest.scale)};
  const BoneAnimation* bone = clip < scene.animations.size() ? bone_of(scene.animations[clip], joint) : nullptr;
  const Transformd pose = bone == nullptr ? rest : bone->interpolate<double>(time_s, rest);
  if (kind == ChannelKind::position) return pose.translation;
  if (kind == ChannelKind::scale) return pose.scale;
  return glm::degrees(euler_from_matrix(EulerOrder{}, matrix_from_quat(pose.rotation)));
}

std::vector<float> all_key_times(std::span<const Channel> channels) {
  std::vector<float> times;
  for (const Channel& channel : channels) times.insert(times.end(), channel.times_s.begin(), channel.times_s.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

double ruler_step(double least, double unit) {
  double step = unit;
  constexpr double kFactors[] = {2.0, 2.5, 2.0};  // 1 2 5 10
  for (int i = 0; step < least; ++i) step *= kFactors[i % 3];
  return step;
}

}  // namespace sinew::viewer
