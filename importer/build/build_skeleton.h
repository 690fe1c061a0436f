// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/issue_log.h"
#include "runtime/animation/skeleton.h"

namespace sinew {

/// The skeleton of all nodes. A node given as a matrix keeps it verbatim, unless an animation moves the node: then the
/// matrix is decomposed once (G50).
/// in   animated[N]   per node: some channel moves its translation, rotation or scale
/// warning those of read_node_transform, node-matrix-animated
Skeleton build_skeleton(const gltf::Document& document, const JointOrder& order, const std::vector<bool>& animated,
                        IssueLog& log);

/// Nodes whose translation, rotation or scale some channel moves.
std::vector<bool> find_animated_nodes(const gltf::Document& document);

}  // namespace sinew
