// SPDX-License-Identifier: MIT
#include "importer/formats/bvh_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace sinew::formats {
namespace {

glm::dquat turn(int axis, double degrees) {
  const double half = degrees * (std::numbers::pi / 360.0);
  glm::dquat out(std::cos(half), 0.0, 0.0, 0.0);
  out[axis] = std::sin(half);  // GLM indexes x y z w
  return out;
}

/// The local rotation and translation of a joint in one frame.
struct JointFrame {
  glm::dvec3 translation;
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
};

JointFrame frame_of(const BvhJoint& joint, const double* values, bool add) {
  JointFrame out{joint.offset};
  for (const BvhChannel& channel : joint.channels) {
    const double value = *values++;
    if (channel.rotates)
      out.rotation = out.rotation * turn(channel.axis, value);
    else
      out.translation[channel.axis] = add ? joint.offset[channel.axis] + value : value;
  }
  out.rotation = glm::normalize(out.rotation);
  return out;
}

/// The keys of one joint. Neighbouring rotations are on one hemisphere.
void add_keys(const Bvh& bvh, const BvhJoint& joint, const BvhMeaning& meaning, int node,
              const std::vector<float>& times_s, ModelDraft& draft) {
  const auto moves = [](const BvhChannel& channel) { return !channel.rotates; };
  const auto turns = [](const BvhChannel& channel) { return channel.rotates; };
  std::vector<glm::vec3> translations;
  std::vector<glm::quat> rotations;
  glm::dquat before(1.0, 0.0, 0.0, 0.0);
  for (std::size_t frame = 0; frame < bvh.frame_count; ++frame) {
    const double* values = bvh.values.data() + frame * bvh.channel_count + joint.first_channel;
    const JointFrame pose = frame_of(joint, values, meaning.positions_add_to_offset);
    before = glm::dot(pose.rotation, before) < 0.0 ? -pose.rotation : pose.rotation;
    rotations.emplace_back(before);
    translations.emplace_back(pose.translation * meaning.metres_per_unit);
  }
  if (std::any_of(joint.channels.begin(), joint.channels.end(), moves))
    draft.add_translations(node, times_s, translations);
  if (std::any_of(joint.channels.begin(), joint.channels.end(), turns)) draft.add_rotations(node, times_s, rotations);
}

}  // namespace

void add_bvh(const Bvh& bvh, const BvhMeaning& meaning, const std::string& clip_name, ModelDraft& draft) {
  const int top = meaning.z_up ? draft.add_node("z_up", -1, glm::dvec3(0.0), turn(0, -90.0)) : -1;
  std::vector<int> node_of_joint;
  for (const BvhJoint& joint : bvh.joints) {
    const int parent = joint.parent == kNone ? top : node_of_joint[joint.parent];
    const bool left_out = joint.is_end_site && !meaning.keep_end_sites;
    node_of_joint.push_back(left_out ? -1 : draft.add_node(joint.name, parent, joint.offset * meaning.metres_per_unit));
  }
  if (bvh.frame_count == 0) return;
  std::vector<float> times_s;
  for (std::size_t frame = 0; frame < bvh.frame_count; ++frame)
    times_s.push_back(static_cast<float>(static_cast<double>(frame) * bvh.frame_time_s));
  draft.begin_animation(clip_name);
  for (std::size_t j = 0; j < bvh.joints.size(); ++j)
    if (node_of_joint[j] >= 0) add_keys(bvh, bvh.joints[j], meaning, node_of_joint[j], times_s, draft);
}

}  // namespace sinew::formats
