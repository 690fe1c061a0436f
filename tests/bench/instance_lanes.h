// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/pose/pose.h"

namespace sinew::bench {

/// Model matrices of many instances of one skeleton, one instance per SIMD lane. This variant is slower than
/// LocalToModelJob. Its matrix products need no shuffles. But poses are stored joint after joint and matrices instance
/// after instance, so every number is gathered and scattered. That takes longer than all other work of either variant.
class InstanceLanes {
 public:
  /// in   instance_count  a multiple of sixteen
  InstanceLanes(const Skeleton& skeleton, std::size_t instance_count)
      : skeleton_(skeleton), instance_count_(instance_count), kept_((skeleton.joint_count() + 1) * 12) {}

  /// in   poses  `pose_pitch` floats from one pose to the next
  /// out  model  [instance][joint]; the same bits as from LocalToModelJob
  void local_to_model(const float* poses, std::size_t pose_pitch, Affine* model);

 private:
  struct alignas(64) Line {
    float floats[16];
  };
  const Skeleton& skeleton_;
  std::size_t instance_count_;
  std::vector<Line> kept_;
};

}  // namespace sinew::bench
