// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/mirror_map.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Joints whose mirrored translation, rotation or scale needs sums of products. Padded to groups of 16 for SIMD lanes.
struct MirroredSums {
  std::vector<std::uint32_t> joints, sources;  ///< [count] padded to a multiple of 16 by repeating the last one
  std::vector<float> factors;  ///< one plane of [count] floats per matrix entry: the rows, then the offsets
};

/// A MirrorMap prepared for MirrorPoseJob. Made once; immutable.
struct MirrorTables {
  std::size_t joint_count = 0;
  /// [floats of a pose] For each float of the mirrored pose, the index of the source float to copy. The highest bit
  /// negates it.
  std::vector<std::uint32_t> copies;
  MirroredSums translation, rotation, scale;  ///< joints for which copying and negating is not enough
};

/// Prepares the tables of a job.
/// in   joints  of a MirrorMap, or a subset that contains its own sources
/// cost O(J), allocates
SINEW_API MirrorTables make_mirror_tables(std::span<const MirroredJoint> joints);

/// Mirrors a pose: each joint gets the reflected transform of its partner on the other side.
/// eq   as make_mirror_map (mirror_map.h), in float. Rotations that are sums of products are normalised. Values that
///      are only copied or negated keep their bits.
/// in   pose  of the tables' joint count
/// out  mirrored  the same shape; must not overlap pose
/// err  size_mismatch     cost O(J), no allocation
struct MirrorPoseJob {
  const MirrorTables* tables = nullptr;
  PoseSpan pose;
  PoseSpan mirrored;
};

SINEW_API ErrorCode check(const MirrorPoseJob& job) noexcept;
SINEW_API void run_unchecked(const MirrorPoseJob& job) noexcept;

}  // namespace sinew
