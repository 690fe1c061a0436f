// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "runtime/pose/pose.h"

namespace sinew {

/// Memory of one pose, for code that is no frame, and the view over it.
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
