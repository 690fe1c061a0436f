// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/plan/compiled_plan.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// The block of memory of one frame, addressed by the offsets of its plan.
struct FrameMemory {
  std::byte* block = nullptr;

  template <class T>
  std::span<T> array(std::size_t at, std::size_t count) const noexcept {
    return {reinterpret_cast<T*>(block + at), count};
  }
  PoseSpan pose(std::size_t at, std::size_t joint_count) const noexcept {
    return pose_over(array<float>(at, PoseSpan::floats_for(joint_count)), joint_count);
  }
};

}  // namespace sinew
