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
  kept = bytes;
  for (std::uint32_t k = 0; k < room.kept; ++k)
    take((TransitionNumbers::kPlanes * PoseSpan::stride_for(joints) +
          TransitionNumbers::kParts * (weights + properties)) *
         sizeof(float));
  if (room.kept > 0) kept_bytes = (bytes - kept) / room.kept;
}

PoseSlot PoseSlots::slot_above(std::size_t index) const noexcept {
  const std::size_t floats = PoseSpan::floats_for(layout_.joints);
  const std::size_t weights = output_.weights.size(), properties = output_.properties.size();
  return {pose_over({at<float>(layout_.poses) + index * floats, floats}, layout_.joints),
          {at<float>(layout_.pose_weights) + index * layout_.weights, weights},
          {at<float>(layout_.pose_properties) + index * layout_.properties, properties}};
}

TransitionNumbers PoseSlots::kept(std::size_t index) const noexcept {
  float* const planes = at<float>(layout_.kept + index * layout_.kept_bytes);
  float* const numbers = planes + TransitionNumbers::kPlanes * PoseSpan::stride_for(layout_.joints);
  const std::size_t weights = TransitionNumbers::kParts * layout_.weights,
                    properties = TransitionNumbers::kParts * layout_.properties;
  return {planes, layout_.joints, {numbers, weights}, {numbers + weights, properties}};
}

PoseSlot PoseSlots::unmirrored() const noexcept {
  const std::size_t floats = PoseSpan::floats_for(layout_.joints);
  return {pose_over({at<float>(layout_.unmirrored), floats}, layout_.joints),
          {at<float>(layout_.unmirrored_weights), output_.weights.size()},
          {}};
}

}  // namespace sinew
