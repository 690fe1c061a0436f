// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/transition/transition_numbers.h"

namespace sinew {

/// The source's pose at a transition's start and one step before it. A step is the duration divided by `steps`.
struct DeadBlendStart {
  TransitionPose source, source_before;
  std::uint32_t steps = 1;
};

/// Finds the source's pose and velocity when a dead blending starts.
/// eq   v = steps (x - x_before), the change per duration; for rotations 2 log(q conj(q_before)) along the short arc,
///      in the parent's space. Faster rotations are slowed down so that they turn half a turn in all.
/// out  numbers  translations in planes 0-2 and their v in 3-5, rotations in 6-9 and their v in 10-12, scales in 13-15
///      and their v in 16-18
/// cost O(J), with a logarithm for each joint; no allocation. Internal to the runtime
void make_extrapolation(const DeadBlendStart& start, const TransitionNumbers& numbers) noexcept;

/// Dead blending (Holden 2023): the source moves on with a decaying velocity and fades into the target's pose.
/// eq   u = progress;  e = (1 - 2^(-4 u)) / (4 ln 2): the velocity halves in each quarter of the duration
///      x_source(u) = x + e v,  q_source(u) = exp(e v / 2) q;  mix of both by w = u^2 (3 - 2 u), rotations by
///      normalised linear interpolation along the short arc
/// in   progress  [0, 1] of the duration. At 1 the pose keeps its bits
/// out  pose      in place; holds the target's current pose on input
/// err  size_mismatch (planes, numbers), not_a_fraction (progress)
/// cost O(J), no allocation. The same bits on all instruction sets
struct DeadBlendJob {
  TransitionNumbers numbers;
  float progress = 0.0f;
  TransitionPose pose;
};

ErrorCode check(const DeadBlendJob& job) noexcept;
void run_unchecked(const DeadBlendJob& job) noexcept;

}  // namespace sinew
