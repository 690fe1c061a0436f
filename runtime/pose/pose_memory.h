// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "runtime/pose/pose.h"

namespace sinew {

/// Owns the memory of one pose. For code outside of frames: frame buffers hold their poses themselves.
class PoseMemory {
 public:
  explicit PoseMemory(std::size_t joint_count)
      : joint_count_(joint_count), lines_(PoseSpan::floats_for(joint_count) / 16 + 1) {}

  PoseSpan span() noexcept {
    return pose_over({lines_.front().floats, PoseSpan::floats_for(joint_count_)}, joint_count_);
  }

 private:
  struct alignas(64) Line {
    float floats[16] = {};
  };
  std::size_t joint_count_;
  std::vector<Line> lines_;
};

}  // namespace sinew
