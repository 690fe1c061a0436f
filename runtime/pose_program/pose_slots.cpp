// SPDX-License-Identifier: MIT
#include "runtime/pose_program/pose_slots.h"

namespace sinew {

PoseSlotLayout::PoseSlotLayout(const PoseProgramAssets& assets, const PoseProgramRoom& room) noexcept
    : joints(assets.skeleton->joint_count()),
      weights(assets.rest_weights.size()),
      properties(assets.rest_properties.size()) {
  const auto take = [&](std::size_t byte_count) {
    const std::size_t at = bytes;
    bytes += (byte_count + 63) / 64 * 64;
    return at;
  };
  const std::size_t pose_bytes = PoseSpan::floats_for(joints) * sizeof(float);
  const std::size_t above = room.slots > 0 ? room.slots - 1 : 0, mirrored = assets.mirror != nullptr ? 1 : 0;
  shares = take(room.slots * sizeof(PoseShare));
  blend_layers = take(room.slots * sizeof(BlendLayer));
  front_bytes = bytes;
  poses = take(above * pose_bytes);
  pose_weights = take(above * weights * sizeof(float));
  pose_properties = take(above * properties * sizeof(float));
  unmirrored = take(mirrored * pose_bytes);
  unmirrored_weights = take(mirrored * weights * sizeof(float));
  model_rotations = take(room.overlays_in_model_space ? 3 * joints * sizeof(glm::quat) : 0);
}

PoseSlot PoseSlots::slot_above(std::size_t index) const noexcept {
  const std::size_t floats = PoseSpan::floats_for(layout_.joints);
  const std::size_t weights = output_.weights.size(), properties = output_.properties.size();
  return {pose_over({at<float>(layout_.poses) + index * floats, floats}, layout_.joints),
          {at<float>(layout_.pose_weights) + index * layout_.weights, weights},
          {at<float>(layout_.pose_properties) + index * layout_.properties, properties}};
}

PoseSlot PoseSlots::unmirrored() const noexcept {
  const std::size_t floats = PoseSpan::floats_for(layout_.joints);
  return {pose_over({at<float>(layout_.unmirrored), floats}, layout_.joints),
          {at<float>(layout_.unmirrored_weights), output_.weights.size()},
          {}};
}

}  // namespace sinew
