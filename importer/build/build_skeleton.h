// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/issue_log.h"
#include "runtime/animation/skeleton.h"

namespace sinew {

/// Builds one skeleton of all nodes. A node given as a matrix keeps it bit for bit. If the node is animated, its matrix
/// is decomposed, because clips animate translation, rotation and scale.
/// in       animated[N]   true if a channel animates the node's translation, rotation or scale
/// warning  as read_node_transform; node-matrix-animated
Skeleton build_skeleton(const gltf::Document& document, const JointOrder& order, const std::vector<bool>& animated,
                        IssueLog& log);

/// Finds the nodes that an animation moves.
/// out   [N]   true if a channel animates the node's translation, rotation or scale
std::vector<bool> find_animated_nodes(const gltf::Document& document);

}  // namespace sinew
