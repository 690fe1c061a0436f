// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/pose/blend_poses.h"
#include "runtime/pose_program/run_pose_program.h"
#include "runtime/transition/transition_numbers.h"

namespace sinew {

/// A pose on the stack with its morph weights and properties. Weights or properties that are not wanted are empty.
struct PoseSlot {
  PoseSpan pose;
  std::span<float> weights, properties;
};

/// Weight and mask of a pose on the stack in the operation that takes it.
struct PoseShare {
  float weight;
  std::uint8_t mask;
};

/// Layout of a run's memory: poses on the stack, and scratch for one operation at a time. Computed once for all runs of
/// a plan. Internal to the runtime.
struct PoseSlotLayout {
  PoseSlotLayout() = default;
  PoseSlotLayout(const PoseProgramAssets& assets, const PoseProgramRoom& room) noexcept;

  std::size_t joints = 0, weights = 0, properties = 0;  ///< of each pose
  /// Offsets in bytes. The lowest pose of the stack is the output, which is not in this memory.
  std::size_t shares = 0, blend_layers = 0, poses = 0, pose_weights = 0, pose_properties = 0, unmirrored = 0,
              unmirrored_weights = 0, model_rotations = 0, kept = 0;
  std::size_t kept_bytes = 0;  ///< bytes of each kept operation
  std::size_t front_bytes =
      0;                  ///< bytes at the start, which every run uses; a single clip that plays alone uses no others
  std::size_t bytes = 0;  ///< total, a multiple of 64
};

/// The memory of a run.
class PoseSlots {
 public:
  /// Keeps a reference to `layout`.
  PoseSlots(const PoseSlotLayout& layout, std::byte* memory, const PoseSlot& output) noexcept
      : layout_(layout), memory_(memory), output_(output) {}

  PoseSlot slot(std::size_t index) const noexcept { return index == 0 ? output_ : slot_above(index - 1); }
  PoseShare& share(std::size_t index) const noexcept { return at<PoseShare>(layout_.shares)[index]; }

  /// A pose of scratch without properties.
  PoseSlot unmirrored() const noexcept;

  /// The morph weights of all slots above slot `index`, one slot after the other, as blend_weights reads them.
  const float* weights_above(std::size_t index) const noexcept {
    return at<float>(layout_.pose_weights) + index * layout_.weights;
  }
  const float* properties_above(std::size_t index) const noexcept {
    return at<float>(layout_.pose_properties) + index * layout_.properties;
  }

  BlendLayer* blend_layers() const noexcept { return at<BlendLayer>(layout_.blend_layers); }
  std::span<glm::quat> model_rotations() const noexcept {  ///< [3 J]
    return {at<glm::quat>(layout_.model_rotations), 3 * layout_.joints};
  }

  /// Numbers that kept operation `index` keeps.
  TransitionNumbers kept(std::size_t index) const noexcept;

 private:
  template <class T>
  T* at(std::size_t offset) const noexcept {
    return reinterpret_cast<T*>(memory_ + offset);
  }
  PoseSlot slot_above(std::size_t index) const noexcept;

  const PoseSlotLayout& layout_;
  std::byte* memory_;
  PoseSlot output_;
};

}  // namespace sinew
