// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {

/// Hemisphere alignment of joints: q and -q are the same rotation. When each joint takes the sign that is nearer to its
/// parent, joints that share a vertex are nearly always on the same hemisphere, and dual-quaternion skinning does not
/// compare signs vertex by vertex (N17).

/// Pairs (nearest ancestor in the skin, joint) of all joints of the skin, ancestors first: SplitPaletteJob::follow.
std::vector<JointPair> hemisphere_edges(const Skeleton& skeleton, const Skin& skin);

/// The distinct pairs (heaviest joint, other joint) of all vertices: SkinDualQuaternionJob::pairs. Empty when there
/// are as many pairs as vertices, where testing the pairs would not pay.     cost O(influences + joints^2)
std::vector<JointPair> sharing_pairs(const VertexInfluences& influences, std::size_t joint_count);

}  // namespace sinew
