// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// Joints of which one property is mapped, in groups of 16 for the lanes of a kernel.
struct RetargetedJoints {
  std::vector<std::uint32_t> targets, sources;  ///< [count] padded to a multiple of 16 by the last one
  std::vector<float> factors;                   ///< planes of [count]
};

/// A joint of the source on the way to a mapped one.
struct StepDown {
  std::uint32_t joint = 0;
  bool is_fixed = false;  ///< it has a fixed matrix: `local` in place of what poses hold
  Transform local;
};

/// Joints that are mapped together: each joint of the source is seen from one joint above.
struct RetargetPass {
  std::vector<std::vector<StepDown>> composed;     ///< mapped joints over several: from each up
  std::vector<std::uint32_t> copied_rotations[2];  ///< targets and sources of rotations that stay as they are
  std::vector<std::uint32_t> copied_translations[2];
  RetargetedJoints rotations;     ///< factors: before and after, x y z w each
  RetargetedJoints translations;  ///< factors: three rows, then the offset
  RetargetedJoints scales;        ///< factors: x y z
};

/// A SkeletonMap as retarget_pose reads it. Made once; immutable.
struct RetargetTables {
  std::size_t source_count = 0, target_count = 0;
  std::vector<float> rest;           ///< the target's rest pose, as planes of a pose
  std::vector<RetargetPass> passes;  ///< more than one where joints see the same one from different joints above

  bool composes() const noexcept {
    return std::any_of(passes.begin(), passes.end(), [](const RetargetPass& pass) { return !pass.composed.empty(); });
  }
};

/// cost O(J), allocates
RetargetTables make_retarget_tables(const SkeletonMap& map, const Skeleton& source, const Skeleton& target);

/// A pose of one skeleton on another.
/// eq   that of make_skeleton_map (skeleton_map.h), in float: within 1e-6 of retarget_pose (retarget_animation.h). On
///      its own skeleton a pose keeps its bits.
/// in   pose     of the tables' source count
///      scratch  of the source count, where `tables.composes()`
/// out  retargeted  of the target count; must not overlap
/// err  size_mismatch     cost O(J), no allocation
struct RetargetPoseJob {
  const RetargetTables* tables = nullptr;
  PoseSpan pose;
  PoseSpan scratch = {};
  PoseSpan retargeted;
};

ErrorCode check(const RetargetPoseJob& job) noexcept;
void run_unchecked(const RetargetPoseJob& job) noexcept;

}  // namespace sinew
