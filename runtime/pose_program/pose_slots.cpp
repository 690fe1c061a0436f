// SPDX-License-Identifier: MIT
#include "runtime/pose_program/pose_slots.h"

namespace sinew {

template <class T>
std::span<T> PoseSlots::take(std::size_t count) noexcept {
  const std::size_t at = bytes_;
  bytes_ += (count * sizeof(T) + 63) / 64 * 64;
  return memory_ == nullptr ? std::span<T>{} : std::span<T>(reinterpret_cast<T*>(memory_ + at), count);
}

PoseSlots::PoseSlots(const PoseProgramAssets& assets, const PoseProgramRoom& room, std::byte* memory,
                     const PoseSlot& output) noexcept
    : memory_(memory), output_(output) {
  const std::size_t joints = assets.skeleton->joint_count(), floats = PoseSpan::floats_for(joints);
  const std::size_t above = room.slots > 0 ? room.slots - 1 : 0;
  poses_ = take<float>(above * floats);
  weights_ = take<float>(above * assets.rest_weights.size());
  properties_ = take<float>(above * assets.rest_properties.size());
  if (assets.mirror != nullptr) {
    const std::span<float> pose = take<float>(floats);
    unmirrored_.weights = take<float>(assets.rest_weights.size());
    if (memory_ != nullptr) unmirrored_.pose = pose_over(pose, joints);
  }
  shares_ = take<Share>(room.slots);
  blend_layers_ = take<BlendLayer>(room.slots);
  model_rotations_ = take<glm::quat>(room.overlays_in_model_space ? 3 * joints : 0);
}

PoseSlot PoseSlots::slot(std::size_t index) const noexcept {
  if (index == 0) return output_;
  const std::size_t above = index - 1, joints = output_.pose.joint_count, floats = PoseSpan::floats_for(joints);
  const std::size_t weights = output_.weights.size(), properties = output_.properties.size();
  return {pose_over(poses_.subspan(above * floats, floats), joints), weights_.subspan(above * weights, weights),
          properties_.subspan(above * properties, properties)};
}

std::span<const float> PoseSlots::weights_above(std::size_t index) const noexcept {
  return weights_.subspan(index * output_.weights.size());
}

std::span<const float> PoseSlots::properties_above(std::size_t index) const noexcept {
  return properties_.subspan(index * output_.properties.size());
}

}  // namespace sinew
