// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Additive layer: adds to a pose the difference of a layer from a reference pose (breathing, aiming, a limp).
/// eq   t' = t + w (t_l - t_r);  q' = normalise(((1 - w) 1 + w d) q), d = q_l conj(q_r), negated where its w < 0;
///      s' = s (1 + w (s_l / s_r - 1)), per component, s_l / s_r = 1 where s_r = 0
/// in   layer, reference  of the same joints as `pose`;   weight  finite, >= 0: 1 adds the whole difference
///      joint_weights[J]  multiply `weight` per joint; empty = all ones
/// out  pose  in place. Joints of weight 0 keep their bits; so does every joint where layer and reference are equal.
/// err  size_mismatch, not_finite     cost O(J), no allocation
struct AddPoseJob {
  PoseSpan layer, reference;
  float weight = 1.0f;
  std::span<const float> joint_weights;
  PoseSpan pose;
};

ErrorCode check(const AddPoseJob& job) noexcept;
void run_unchecked(const AddPoseJob& job) noexcept;

}  // namespace sinew
