// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/procedures/springs/springs.h"

namespace sinew {

/// A discontinuity between two frames.
enum class SpringEvent : std::uint8_t {
  none,
  reset,     ///< springs jump to their goals and rest there; no time passes
  teleport,  ///< springs move along with the joint that they hang on, and keep their swing relative to that joint
};

/// Work of one frame.
struct SpringCounts {
  std::uint32_t ticks = 0;          ///< simulated ticks, including the look-ahead tick of a frame between two ticks
  std::uint32_t joints = 0;         ///< sum over all ticks of the joints computed; 0 = asleep
  std::uint32_t dropped_ticks = 0;  ///< ticks dropped because of SpringSettings::max_ticks
  bool asleep = false;
};

/// Simulates springs for one frame, in ticks of a fixed length. Ticks do not depend on the frame rate.
/// eq   for each joint, parents first, in each tick (VRMC_springBone 1.0):
///      n = x + (x - x_before)(1 - drag) + a stiffness h + gravity h, a the direction of the goal, h the length of a
///      tick;
///      n = head + length * direction(n - head). This is repeated after each collider that moves n.
///      The bone points to n. With SpringJoint::lagging_length or shear, its end may differ from n.
///      Transforms that springs hang on are interpolated between this frame and the two before. Between two ticks, the
///      result moves from the last tick towards the next one, computed with extrapolated transforms.
/// in   pose    [J of the skeleton] local transforms;   root  world transform above all root joints, in double
///      dt_s    seconds since the frame before, >= 0;   weight  [0, 1] of springs against the pose
///      state   Springs::state_bytes, all zero before the first frame, which resets;   scratch  Springs::scratch_bytes
/// out  pose    rotations of the joints of springs;   state
///      tails   [joints of the setup] positions in the world, or empty;   counts  may be null
/// err  size_mismatch (also memory that is not aligned to 8), overlapping_buffers, not_finite, times_not_increasing,
///      not_a_fraction
/// cost O(ancestors + joints * (ticks + 1) * colliders of each), no allocation; sleeping springs only read the input
struct SpringsJob {
  const Springs* springs = nullptr;
  const Skeleton* skeleton = nullptr;
  PoseSpan pose;
  Affined root;
  double dt_s = 0.0;
  std::span<std::byte> state, scratch;
  SpringEvent event = SpringEvent::none;
  float weight = 1.0f;
  std::span<Vec3<double>> tails = {};
  SpringCounts* counts = nullptr;
};

SINEW_API ErrorCode check(const SpringsJob& job) noexcept;
SINEW_API void run_unchecked(const SpringsJob& job) noexcept;

/// True if the springs sleep and `root` is the root of their last frame. Frames then change nothing until the pose
/// changes.
/// in   state  Springs::state_bytes of these springs
SINEW_API bool springs_asleep(std::span<const std::byte> state, const Affined& root) noexcept;

/// How often the springs fell asleep. During a sleep this number is above 0 and identifies the sleep.
SINEW_API std::uint64_t springs_sleeps(std::span<const std::byte> state) noexcept;

}  // namespace sinew
