// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/transition/transition_numbers.h"

namespace sinew {

/// The two poses at a transition's start and one step before it. A step is the transition's duration divided by
/// `steps`.
struct InertializeStart {
  TransitionPose source, source_before, target, target_before;
  std::uint32_t steps = 1;
};

/// Finds the offset of the source from the target when an inertialization starts, and the offset's velocity.
/// eq   x = x_source - x_target;  v = steps (x - x_before), its change per duration;  k = v.x / x.x,  r = v - k x
///      Rotations: x = 2 log(q_source conj(q_target)) along the short arc, in the parent's space. A rotation that would
///      grow over half a turn keeps no velocity; one below 1e-7 counts as 0.
/// out  numbers  planes of x, c = max(1, -k / 5), max(k, -5) + 4 and r: translations in planes 0-7, rotations in 8-15,
///      scales in 16-23. Rotations are stored as a quarter of their angle. Plane 24 has flags for each block of joints:
///      its first three numbers are 0 if no joint of the block has an offset of translation, rotation, scale
///      respectively
/// cost O(J), with two logarithms for each joint; no allocation. Internal to the runtime
void make_offsets(const InertializeStart& start, const TransitionNumbers& numbers) noexcept;

/// Inertialization (Bollo 2018): adds the offset from make_offsets to the target's pose, while the offset decays.
/// eq   u = progress;  c = max(1, -k / 5), s = min(1, c u);  p = (1 - s)^4 (1 + (max(k, -5) + 4) s)
///      offset = p x + u (1 - u)^4 r.  p is the quintic with p(0) = 1, p'(0) = k per duration and a fourfold zero at
///      its end. It ends early where it would otherwise cross zero. r is the velocity perpendicular to x, so the whole
///      velocity is continuous.
/// in   progress  [0, 1] of the duration. At 1 the pose keeps its bits
/// out  pose      in place; holds the target's current pose on input
/// err  size_mismatch (planes, numbers), not_a_fraction (progress)
/// cost O(J); blocks of 16 joints without an offset are skipped; no allocation. The same bits on all instruction sets
struct InertializeJob {
  TransitionNumbers numbers;
  float progress = 0.0f;
  TransitionPose pose;
};

ErrorCode check(const InertializeJob& job) noexcept;
void run_unchecked(const InertializeJob& job) noexcept;

}  // namespace sinew
