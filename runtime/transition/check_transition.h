// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/result.h"
#include "runtime/transition/transition_numbers.h"

namespace sinew {

/// Checks the rules that both kinds of transitions share.     err  size_mismatch, not_a_fraction
inline ErrorCode check_transition(const TransitionNumbers& numbers, float progress,
                                  const TransitionPose& pose) noexcept {
  constexpr std::size_t kParts = TransitionNumbers::kParts;
  const std::size_t joints = numbers.joint_count;
  if (!is_pose_of(pose.pose, joints) || (joints > 0 && numbers.planes == nullptr)) return ErrorCode::size_mismatch;
  if (numbers.weights.size() < kParts * pose.weights.size()) return ErrorCode::size_mismatch;
  if (numbers.properties.size() < kParts * pose.properties.size()) return ErrorCode::size_mismatch;
  return progress >= 0.0f && progress <= 1.0f ? ErrorCode::ok : ErrorCode::not_a_fraction;
}

}  // namespace sinew
