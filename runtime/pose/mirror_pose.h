// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/mirror_map.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Joints of which one property is a sum of products, in groups of 16 for the lanes of a kernel.
struct MirroredSums {
  std::vector<std::uint32_t> joints, sources;  ///< [count] padded to a multiple of 16 by the last one
  std::vector<float> factors;                  ///< a plane of [count] for each entry: rows, then offsets
};

/// A MirrorMap as mirror_pose reads it. Made once; immutable.
struct MirrorTables {
  std::size_t joint_count = 0;
  /// [floats of a pose] for each float of the mirrored pose the index of the float that it copies; the highest bit
  /// negates it.
  std::vector<std::uint32_t> copies;
  MirroredSums translation, rotation, scale;  ///< of joints that copies are not enough for
};

/// in   joints  of MirrorMap, or of some joints alone with sources among them
/// cost O(J), allocates
MirrorTables make_mirror_tables(std::span<const MirroredJoint> joints);

/// The mirrored pose: each joint gets what its partner has, reflected.
/// eq   that of make_mirror_map (mirror_map.h), in float. Rotations that are sums of products are normalised; the
///      others, and all that copies and negates, keep their bits.
/// in   pose  of the tables' joint count
/// out  mirrored  the same shape; must not overlap pose
/// err  size_mismatch     cost O(J), no allocation
struct MirrorPoseJob {
  const MirrorTables* tables = nullptr;
  PoseSpan pose;
  PoseSpan mirrored;
};

ErrorCode check(const MirrorPoseJob& job) noexcept;
void run_unchecked(const MirrorPoseJob& job) noexcept;

}  // namespace sinew
