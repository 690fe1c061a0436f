// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/pose/blend_poses.h"
#include "runtime/pose_program/run_pose_program.h"

namespace sinew {

/// A pose on the stack with its morph weights and properties. Numbers that are not wanted are empty.
struct PoseSlot {
  PoseSpan pose;
  std::span<float> weights, properties;
};

/// The memory of a run: the poses on the stack, and scratch for one operation at a time. The lowest slot is the output.
/// Internal to pose_program/.
class PoseSlots {
 public:
  /// in   memory  null only counts the bytes
  PoseSlots(const PoseProgramAssets& assets, const PoseProgramRoom& room, std::byte* memory,
            const PoseSlot& output) noexcept;

  std::size_t bytes() const noexcept { return bytes_; }

  PoseSlot slot(std::size_t index) const noexcept;
  PoseSlot unmirrored() const noexcept { return unmirrored_; }  ///< scratch, without properties

  /// The numbers of all slots above `index`, one slot behind the other, as blend_weights reads them.
  std::span<const float> weights_above(std::size_t index) const noexcept;
  std::span<const float> properties_above(std::size_t index) const noexcept;

  /// The share of a pose on the stack in the operation that takes it.
  struct Share {
    float weight;
    std::uint8_t mask;
  };
  Share& share(std::size_t index) const noexcept { return shares_[index]; }

  std::span<BlendLayer> blend_layers() const noexcept { return blend_layers_; }
  std::span<glm::quat> model_rotations() const noexcept { return model_rotations_; }  ///< [3 J]

 private:
  template <class T>
  std::span<T> take(std::size_t count) noexcept;

  std::byte* memory_;
  std::size_t bytes_ = 0;
  PoseSlot output_, unmirrored_;
  std::span<float> poses_, weights_, properties_;  // of the slots above the output
  std::span<Share> shares_;
  std::span<BlendLayer> blend_layers_;
  std::span<glm::quat> model_rotations_;
};

}  // namespace sinew
