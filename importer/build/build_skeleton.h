// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/issue_log.h"
#include "runtime/animation/skeleton.h"

namespace sinew {

/// Builds one skeleton of all nodes. A node that the file gives as a matrix keeps the matrix bit for bit. An animation
/// needs translation, rotation and scale, so the matrix of an animated node is decomposed (G50).
/// in       animated[N]   true for nodes whose translation, rotation or scale some channel animates
/// warning  those of read_node_transform, node-matrix-animated
Skeleton build_skeleton(const gltf::Document& document, const JointOrder& order, const std::vector<bool>& animated,
                        IssueLog& log);

/// out   [N]   true for nodes whose translation, rotation or scale some channel animates
std::vector<bool> find_animated_nodes(const gltf::Document& document);

}  // namespace sinew
