// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/compress/virtual_vertices.h"

namespace sinew {

/// How far an error of a joint's local transform moves the virtual vertices of the joint and its descendants. It is the
/// worst case over an animation, in metres of model space per unit of error. The search uses it as a first guess for
/// sharing out the budget; the compiled clip is measured afterwards.
struct JointReach {
  double translation = 0.0;  ///< per unit of length in the parent's space
  double rotation = 0.0;     ///< metres per radian
  double scale = 0.0;        ///< per unit of scale
};

/// Computes the reach of each joint.
/// eq   from the tips to the roots: radius[j] = max(|M[j] c - o[j]|, |o[child] - o[j]| + radius[child])
/// cost O(J), allocates
std::vector<JointReach> joint_reach(const Animation& animation, const Skeleton& skeleton,
                                    const VirtualVertices& vertices);

}  // namespace sinew
