// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/result.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// One layer of a blend. `joint_weights[J]` multiplies `weight` per joint; empty = all ones.
struct BlendLayer {
  PoseSpan pose;
  float weight = 1.0f;
  std::span<const float> joint_weights;
};

/// Weighted mean of poses; where the weights of a joint sum to less than 1 the rest pose fills up.
/// eq   t = sum(w t) / sum(w), s likewise; q = normalise(sum(w sign(dot(q, q_pivot)) q))   (Kavan et al. 2008, sec.
///      3) Pivot: the layer with the largest weight, or rest where its share is larger. Of several layers with the
///      largest weight, the one whose rotation is nearest to rest; of several such, the one nearest to a fixed
///      rotation.
/// The order of layers does not matter, except that
/// - sums are rounded in that order: translations and scales differ by 2e-6 of their size, rotations by 1e-6 rad;
/// - a rotation may come out as -q instead of q;
/// - where the share of rest equals the largest weight within rounding, the order decides which of them is the pivot.
/// in   layers[L]  poses of equal joint count, weights finite and >= 0;   rest  same joint count
/// out  pose       may be one of the inputs
/// err  size_mismatch, not_finite     cost O(J * L), no allocation
struct BlendPosesJob {
  std::span<const BlendLayer> layers;
  PoseSpan rest;
  PoseSpan pose;
};

ErrorCode check(const BlendPosesJob& job) noexcept;
void run(const BlendPosesJob& job) noexcept;

}  // namespace sinew
