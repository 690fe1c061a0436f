// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// One layer of a blend. `joint_weights[J]` multiplies `weight` per joint; empty = all ones.
struct BlendLayer {
  PoseSpan pose;
  float weight = 1.0f;
  std::span<const float> joint_weights;
};

/// Weighted mean of poses; where the weights of a joint sum to less than 1 the rest pose fills up.
/// eq   t = sum(w t) / sum(w), s likewise; q = normalise(sum(w sign(dot(q, q_pivot)) q))   (Kavan et al. 2008, sec. 3)
///      Pivot: the layer with the largest weight, or rest where its share is larger; of several layers with the largest
///      weight the first.
/// The order of layers changes no more than rounding and the sign of the quaternion, except where three or more
/// rotations count, the first two weights are equal, and some rotation is more than 90 degrees from the pivot: then
/// another order may align hemispheres in another way. Equal weights at 0, 170 and -170 degrees give 0 or +-127
/// degrees.
/// in   layers[L]  poses of equal joint count, weights finite and >= 0;   rest  same joint count
/// out  pose  may be one of the inputs
/// err  size_mismatch, not_finite;   cost O(J * L), no allocation
struct BlendPosesJob {
  std::span<const BlendLayer> layers;
  PoseSpan rest;
  PoseSpan pose;
};

ErrorCode check(const BlendPosesJob& job) noexcept;
void run_unchecked(const BlendPosesJob& job) noexcept;

}  // namespace sinew
