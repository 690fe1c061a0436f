// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// A joint on the way from the root of a skeleton to a foot.
struct LegJoint {
  std::uint32_t joint = 0;
  bool is_fixed = false;  ///< it has a fixed matrix: `rest` in place of what poses hold
  Transformd rest;
};

/// The joints that place a leg, from the root down, and which of them are the leg.
struct LegChain {
  std::vector<LegJoint> joints;
  std::size_t upper = 0, lower = 0, foot = 0;  ///< hip, knee and ankle, into `joints`
  std::size_t toes = 0;                        ///< ball of the foot; 0 = there is none
  std::size_t hips = 0;                        ///< the joint that comes down with all legs; of the target alone
};

/// Leg of the source and of the target, and where their feet are in model space while the source rests.
struct LegPair {
  LegChain source, target;
  Vec3<double> source_foot{0.0}, source_toes{0.0};
  Vec3<double> target_foot{0.0}, target_toes{0.0};
  Vec3<double> bend{0.0};      ///< where the knee goes when the leg is straight; unit, in the upper leg's space
  double source_length = 0.0;  ///< of both bones of the leg
  double target_length = 0.0;
};

/// What holding feet needs to know of two skeletons. Made once by make_feet_map; immutable.
struct FeetMap {
  std::vector<LegPair> legs;
  double ratio = 1.0;          ///< of heights, target to source: paths of feet are as much longer
  std::uint32_t hips = kNone;  ///< of the target, above all legs; kNone = no mapped joint is
};

/// The joints of a leg, by their number.
struct LegJoints {
  std::uint32_t upper = kNone, lower = kNone, foot = kNone, toes = kNone;
};

/// The legs of both skeletons: those of humanoids, or the given ones. A leg that is not mapped whole (hip, knee, ankle)
/// in both is left out; toes are optional.
/// in   map   of the same skeletons
///      legs  joints of the target, where the map does not know them
/// cost O(J log J), allocates
FeetMap make_feet_map(const SkeletonMap& map, const Skeleton& source, const Skeleton& target,
                      const std::vector<LegJoints>& legs = {});

}  // namespace sinew
