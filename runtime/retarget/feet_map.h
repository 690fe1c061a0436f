// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// A joint on the path from the root of a skeleton to a foot.
struct LegJoint {
  std::uint32_t joint = 0;
  bool is_fixed = false;  ///< the joint has a fixed matrix: `rest` replaces the transform of the pose
  Transformd rest;
};

/// The joints that place a leg, from the root down, and the indices of the leg joints among them.
struct LegChain {
  std::vector<LegJoint> joints;
  std::size_t upper = 0, lower = 0, foot = 0;  ///< indices of hip, knee and ankle in `joints`
  std::size_t toes = 0;                        ///< index of the ball of the foot; 0 = the leg has none
  std::size_t hips = 0;  ///< index of the joint that is lowered together with all legs; target only
};

/// A leg of the source and its counterpart on the target. Foot places are in model space, while the source is at rest.
struct LegPair {
  LegChain source, target;
  Vec3<double> source_foot{0.0}, source_toes{0.0};
  Vec3<double> target_foot{0.0}, target_toes{0.0};
  Vec3<double> bend{0.0};      ///< direction of the knee when the leg is straight; unit, in the space of the upper leg
  double source_length = 0.0;  ///< upper plus lower leg
  double target_length = 0.0;
};

/// The legs of two skeletons, prepared for hold_feet. Made once by make_feet_map; immutable.
struct FeetMap {
  std::vector<LegPair> legs;
  double ratio = 1.0;          ///< height ratio, target to source; paths of feet are scaled by it
  std::uint32_t hips = kNone;  ///< joint of the target above all legs; kNone = no mapped joint is above all of them
};

/// The joints at the hip, the knee, the ankle and the ball of the foot of one leg. `toes` may be kNone.
struct LegJoints {
  std::uint32_t upper = kNone, lower = kNone, foot = kNone, toes = kNone;
};

/// Finds the legs of both skeletons: those of the humanoid bones, or the given ones. A leg is left out unless hip, knee
/// and ankle are mapped in both skeletons. Toes are optional.
/// in   map   of the same skeletons
///      legs  joints of the target, for skeletons whose humanoid bones the map does not know
/// cost O(J log J), allocates
SINEW_API FeetMap make_feet_map(const SkeletonMap& map, const Skeleton& source, const Skeleton& target,
                                const std::vector<LegJoints>& legs = {});

}  // namespace sinew
