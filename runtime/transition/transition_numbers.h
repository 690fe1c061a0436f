// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/pose/pose.h"

namespace sinew {

/// Numbers that stay the same during a transition, computed from the poses at its start. Each kind of transition
/// documents its own planes.
/// owns  nothing: a view of floats_for(...) floats, 64-byte aligned
struct TransitionNumbers {
  static constexpr std::size_t kPlanes = 25;  ///< each as long as a plane of a pose
  static constexpr std::size_t kBlock = 16;   ///< joints that can be skipped together; planes have whole blocks
  static constexpr std::size_t kParts = 3;    ///< floats for each morph weight and property

  float* planes = nullptr;
  std::size_t joint_count = 0;
  std::span<float> weights, properties;  ///< [kParts W], [kParts P]; empty: not wanted

  std::size_t stride() const noexcept { return PoseSpan::stride_for(joint_count); }
  float* plane(std::size_t p) const noexcept { return planes + p * stride(); }
};

/// A pose with its morph weights and properties. All poses of one transition have equal sizes.
struct TransitionPose {
  PoseSpan pose;
  std::span<float> weights, properties;
};

}  // namespace sinew
