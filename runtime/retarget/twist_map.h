// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// A joint along an arm or leg bone that only turns about the bone. Twist joints spread the twist of the skin over the
/// length of the limb.
struct TwistJoint {
  std::uint32_t joint = 0, driver = 0;  ///< `driver` is the joint whose twist is shared
  bool is_below_driver = false;         ///< the driver is its parent; otherwise both have the same parent
  Vec3<double> axis{1, 0, 0};           ///< unit, along the bone, in the space of the joint's parent
  /// Share of the driver's twist. It grows from 0 at the elbow to 1 at the hand. Along an upper bone, which itself has
  /// the whole twist, it runs from -1 at the shoulder to 0 at the elbow.
  double share = 0.0;
  Quat<double> rest{1, 0, 0, 0}, driver_rest{1, 0, 0, 0};
};

/// Twist joints of a skeleton. Made once by make_twist_map; immutable.
struct TwistMap {
  std::vector<TwistJoint> joints;  ///< rising joint indices
};

/// Finds the twist joints of a humanoid that a skeleton map leaves at rest. A twist joint is a child of an upper or
/// lower arm or leg and lies along that bone. Its name contains the word `twist` or `roll`. Keys of twist joints are
/// rarely worth copying: most programs compute them, and rigs have different numbers of them. Joints that carry the
/// next bone (Rigify, Daz) are not twist joints: they rest, and the hand takes over the whole rotation.
/// in   map  to `target`
/// cost O(J log J), allocates
TwistMap make_twist_map(const SkeletonMap& map, const Skeleton& target);

}  // namespace sinew
