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

/// A jump between two frames.
enum class SpringEvent : std::uint8_t {
  none,
  reset,     ///< springs take their goal and are at rest; no time passes
  teleport,  ///< springs move along with the joint that they hang on, and keep their swing relative to it
};

/// Work of one frame.
struct SpringCounts {
  std::uint32_t ticks = 0;          ///< steps of the simulation, and the one that a frame between two ticks looks ahead
  std::uint32_t joints = 0;         ///< joints computed in all ticks; 0 = asleep
  std::uint32_t dropped_ticks = 0;  ///< time beyond SpringSettings::max_ticks
  bool asleep = false;
};

/// One frame of springs, in ticks of a fixed length. Ticks do the same at any frame rate.
/// eq   for each joint, parents first, in each tick (VRMC_springBone 1.0):
///      n = x + (x - x_before)(1 - drag) + a stiffness h + gravity h, a the direction of the goal;
///      n = head + length * direction(n - head); the same again after each collider that pushes n away;
///      the bone points to n, and n need not be its end where SpringJoint::lagging_length is set or scales shear
///      Transforms that springs hang on are interpolated between this frame and the two before. Between two ticks, the
///      result moves from the last tick towards the next one, computed with extrapolated transforms.
/// in   pose    [J of the skeleton] local transforms;   root  world transform above all root joints, in double
///      dt_s    seconds since the frame before, >= 0;   weight  [0, 1] of springs against the pose
///      state   Springs::state_bytes, all zero before the first frame, which resets;   scratch  Springs::scratch_bytes
/// out  pose    rotations of the joints of springs;   state
///      tails   [joints of the setup] positions in the world, or empty;   counts  may be null
/// err  size_mismatch (also memory that is not aligned to 8), overlapping_buffers, not_finite, times_not_increasing,
///      not_a_fraction
/// cost O(ancestors + joints * (ticks + 1) * colliders of each), no allocation; asleep only reads the input
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

/// True if a state sleeps, and the root is that of its last frame: until the pose changes, frames leave it as it is.
/// in   state  Springs::state_bytes of these springs
SINEW_API bool springs_asleep(std::span<const std::byte> state, const Affined& root) noexcept;

/// How often a state fell asleep: while it sleeps, a number above 0 that names this sleep.
SINEW_API std::uint64_t springs_sleeps(std::span<const std::byte> state) noexcept;

}  // namespace sinew
