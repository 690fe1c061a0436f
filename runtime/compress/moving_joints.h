// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "runtime/animation/truth_pose.h"
#include "runtime/compress/truth_samples.h"
#include "runtime/compress/virtual_vertices.h"

namespace sinew {

/// A joint that an animation moves. Joints that it does not move belong to the nearest moving joint above them.
struct MovingJoint {
  std::uint32_t joint = 0;
  std::uint32_t parent = kNone;  ///< index of the nearest moving joint above; kNone = none
  Affined from_parent;  ///< constant: from the joint's parent space to the space of `parent`, or to model space
  Aabb own;             ///< virtual vertices of the joint, and of the joints that belong to it, in its space
  Aabb below;           ///< `own`, and all virtual vertices below as they pass over the animation.

  /// Indices into Animation::bones of the tracks that count, in the order translation, scale, rotation; kNone = none
  std::array<std::uint32_t, 3> bone_of{kNone, kNone, kNone};
};

/// The moving joints of an animation, parents first. Joints with a fixed matrix do not move.
/// cost O(J + moving joints x their depth), allocates
std::vector<MovingJoint> moving_joints(const Animation& animation, const Skeleton& skeleton,
                                       const VirtualVertices& vertices);

/// The local transform of a moving joint at one time.
Transformd local_at(const MovingJoint& joint, const Animation& animation, const Skeleton& skeleton, double time_s);

/// The largest squared length of `difference * c` over the corners of a box.
double longest_squared(const Affined& difference, const Aabb& box) noexcept;

}  // namespace sinew
