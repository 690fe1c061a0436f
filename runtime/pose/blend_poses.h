// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// One layer of a blend. `joint_weights[J]` multiplies `weight` per joint; empty = all ones.
struct BlendLayer {
  PoseSpan pose;
  float weight = 1.0f;
  std::span<const float> joint_weights;
};

/// Weighted mean of poses. Where the weights of a joint sum to less than 1, the rest pose gets the remaining weight.
/// eq   t = sum(w t) / sum(w), s likewise; q = normalise(sum(w sign(dot(q, q_pivot)) q))   (Kavan et al. 2008, sec. 3)
///      The pivot is the layer with the largest weight, or the rest pose where it has more weight than each layer.
///      Among layers of equal weight the first one is the pivot.
/// The order of the layers matters only for rounding and for the sign of the quaternion, with one exception. If the two
/// largest weights are equal and a third rotation counts, two layers may serve as pivot. Rotations more than 90 degrees
/// from it can then align differently: equal weights at 0, 170 and -170 degrees give 0 or +-127 degrees.
/// in   layers[L]  poses of equal joint count, weights finite and >= 0;   rest  same joint count
/// out  pose  may be one of the inputs
/// err  size_mismatch, not_finite, negative_weight;   cost O(J * L), no allocation
struct BlendPosesJob {
  std::span<const BlendLayer> layers;
  PoseSpan rest;
  PoseSpan pose;
};

SINEW_API ErrorCode check(const BlendPosesJob& job) noexcept;
SINEW_API void run_unchecked(const BlendPosesJob& job) noexcept;

/// Weighted mean of the morph weights of several layers. Where the layer weights sum to less than 1, the rest weights
/// get the remaining weight, as in BlendPosesJob.
/// eq   out[i] = (sum(w[l] * x[l][i]) + r * rest[i]) / (sum(w[l]) + r),  r = max(0, 1 - sum(w[l]));
///      magnitudes below 1e-20 become 0, because denormal numbers are slow
/// in   layers[L]  only their weights w[l] are read;   rest[W]
///      first[W], others[(L - 1) * W]  the morph weights x[0], then x[1], x[2], ...
/// out  first[W]   the blended weights
/// cost O(W * L), no allocation
SINEW_API void blend_weights(std::span<const BlendLayer> layers, std::span<const float> rest, std::span<float> first,
                             std::span<const float> others) noexcept;

}  // namespace sinew
