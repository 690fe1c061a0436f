// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// Joints for which one property (rotation, translation or scale) is mapped. Padded to groups of 16 for SIMD lanes.
struct RetargetedJoints {
  std::vector<std::uint32_t> targets, sources;  ///< [count] padded to a multiple of 16 by repeating the last one
  std::vector<float> factors;  ///< planes of `count` floats; the number of planes depends on the property
};

/// A joint of the source on the path between a mapped joint and its nearest mapped ancestor.
struct ChainJoint {
  std::uint32_t joint = 0;
  bool is_fixed = false;  ///< the joint has a fixed matrix: `local` replaces the transform of the pose
  Transform local;
};

/// Joints that are mapped in one pass. Within a pass, each source joint is expressed relative to one ancestor only.
struct RetargetPass {
  /// Paths of the mapped joints whose parent is not their mapped ancestor: from the joint up to below that ancestor
  std::vector<std::vector<ChainJoint>> composed;
  std::vector<std::uint32_t> copied_rotations[2];  ///< targets and sources of rotations that are copied unchanged
  std::vector<std::uint32_t> copied_translations[2];
  RetargetedJoints rotations;     ///< factors: quaternions to multiply from the left and the right, x y z w each
  RetargetedJoints translations;  ///< factors: the three rows of a matrix, then the offset
  RetargetedJoints scales;        ///< factors: x y z
};

/// A SkeletonMap prepared for RetargetPoseJob. Made once; immutable.
struct RetargetTables {
  std::size_t source_count = 0, target_count = 0;
  std::vector<float> rest;  ///< the reference pose of the target, as planes of a pose.
  /// There are several passes if target joints need the same source joint relative to different ancestors
  std::vector<RetargetPass> passes;

  bool composes() const noexcept {
    return std::any_of(passes.begin(), passes.end(), [](const RetargetPass& pass) { return !pass.composed.empty(); });
  }
};

/// Prepares the tables of a job.
/// cost O(J), allocates
SINEW_API RetargetTables make_retarget_tables(const SkeletonMap& map, const Skeleton& source, const Skeleton& target);

/// Retargets a pose of one skeleton to another.
/// eq   as make_skeleton_map (skeleton_map.h), in float: within 1e-6 of retarget_pose (retarget_animation.h). On its
///      own skeleton a pose keeps its bits.
/// in   pose     of the tables' source count
///      scratch  of the source count; needed only if `tables->composes()`
/// out  retargeted  of the target count; must not overlap
/// err  size_mismatch     cost O(J), no allocation
struct RetargetPoseJob {
  const RetargetTables* tables = nullptr;
  PoseSpan pose;
  PoseSpan scratch = {};
  PoseSpan retargeted;
};

SINEW_API ErrorCode check(const RetargetPoseJob& job) noexcept;
SINEW_API void run_unchecked(const RetargetPoseJob& job) noexcept;

}  // namespace sinew
