// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {

// Hemisphere alignment of joints. q and -q are the same rotation, and dual-quaternion skinning must blend quaternions
// of one hemisphere (dot product >= 0). If each joint takes the sign that is nearer to its parent, joints of one vertex
// nearly always agree. Skinning then need not compare signs per vertex.

/// Pairs (nearest ancestor in the skin, joint) for all joints of the skin, ancestors first: SplitPaletteJob::follow.
std::vector<JointPair> hemisphere_edges(const Skeleton& skeleton, const Skin& skin);

/// The distinct pairs (heaviest joint, other joint) of all vertices: SkinDualQuaternionJob::pairs. Empty if there are
/// as many pairs as vertices: testing the pairs would then cost more than it saves.
/// cost O(influences + joints^2)
std::vector<JointPair> joint_pairs_of_vertices(const VertexInfluences& influences, std::size_t joint_count);

}  // namespace sinew
