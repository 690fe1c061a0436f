// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// A joint beside a bone of an arm or leg that turns about the bone alone, so that the skin does not wring in one
/// place.
struct TwistJoint {
  std::uint32_t joint = 0, driver = 0;  ///< `driver` is the joint whose twist it shares
  bool is_below_driver = false;         ///< the driver is its parent; else both have one parent
  Vec3<double> axis{1, 0, 0};           ///< unit, along the bone, in the space of the joint's parent
  /// Of the driver's twist: 0 to 1 beside a lower bone, from elbow to hand; -1 to 0 beside an upper bone, which has the
  /// whole twist, from shoulder to elbow.
  double share = 0.0;
  Quat<double> rest{1, 0, 0, 0}, driver_rest{1, 0, 0, 0};
};

/// Twist joints of a skeleton. Made once by make_twist_map; immutable.
struct TwistMap {
  std::vector<TwistJoint> joints;  ///< rising
};

/// The twist joints of a human body that a map leaves at rest, by their names and places: a child of an upper or lower
/// arm or leg with the word `twist` or `roll` in its name, which lies along the bone. They rarely have keys worth
/// copying, because most programs compute them, and rigs have different numbers of them. Joints that carry the next
/// bone (Rigify, Daz) are none: the hand takes over what the source's have, and they rest.
/// in   map  to `target`
/// cost O(J log J), allocates
TwistMap make_twist_map(const SkeletonMap& map, const Skeleton& target);

}  // namespace sinew
