// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {

/// A rotation has two quaternions. With the signs chosen along the skeleton, joints that share a vertex nearly always
/// are on one side already, and dual-quaternion skinning need not look vertex by vertex (N17).

/// Each joint of the skin after its nearest ancestor in the skin, ancestors first (SplitPaletteJob::follow).
std::vector<JointPair> hemisphere_edges(const Skeleton& skeleton, const Skin& skin);

/// The distinct pairs (heaviest joint, other joint) of all vertices (SkinDualQuaternionJob::pairs); none when they are
/// not fewer than the vertices, so that looking at them would not pay.     cost O(influences + joints^2)
std::vector<JointPair> sharing_pairs(const VertexInfluences& influences, std::size_t joint_count);

}  // namespace sinew
