// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// The frame in which an additive layer turns joints.
enum class DeltaFrame : std::uint8_t {
  parent,  ///< a nod stays a nod in the parent's axes, however far the joint has turned
  joint    ///< the layer turns about the joint's own axes, as Unreal and Maya do: a twist stays a twist
};

/// Adds an additive layer (breathing, aiming, a limp) to a pose. The delta is the layer minus its reference pose.
/// eq   t' = t + w (t_l - t_r);  q' = normalise(p q), p = (1 - w) 1 + w d, d = q_l conj(q_r), negated where its w < 0;
///      in the joint's frame q' = normalise(q p), d = conj(q_r) q_l;
///      s' = s (1 + w (s_l / s_r - 1)), per component, s_l / s_r = 1 where s_r = 0
///      A weight below 0 subtracts: it undoes the addition of -w. Then p and d are those of -w, and
///      q' = normalise(conj(p) q), or normalise(q conj(p));  s' = s / (1 - w (s_l / s_r - 1)), s where that divides by
///      0
/// in   layer, reference  poses of the same joints as `pose`;   weight  finite; 1 adds the whole delta, -1 subtracts it
///      joint_weights[J]  >= 0, multiply `weight` per joint; empty = all ones
/// out  pose  changed in place. Joints of weight 0 keep their bits, and so do joints whose layer equals the reference.
/// err  size_mismatch, not_finite, negative_weight (of a joint)     cost O(J), no allocation
struct AddPoseJob {
  PoseSpan layer, reference;
  float weight = 1.0f;
  std::span<const float> joint_weights;
  PoseSpan pose;
  DeltaFrame frame = DeltaFrame::parent;
};

SINEW_API ErrorCode check(const AddPoseJob& job) noexcept;
SINEW_API void run_unchecked(const AddPoseJob& job) noexcept;

}  // namespace sinew
