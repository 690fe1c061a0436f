// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/file/document.h"

namespace sinew {

/// The nodes of a document in skeleton order: breadth-first, all roots first, children in the file's order.
struct JointOrder {
  std::vector<std::uint32_t> node_of_joint;  ///< [N]
  std::vector<std::uint32_t> joint_of_node;  ///< [N]
  std::vector<std::uint32_t> parents;        ///< [N] joint of the parent, kNone for a root
  std::vector<std::uint32_t> level_begin;    ///< [depth + 1] first joint of each depth, last entry = N
  std::vector<std::uint32_t> root_of_node;   ///< [N] node at the top of each node's tree
};

/// Orders all nodes, whether a scene lists them or not: skins and clips may use any node (G32, G33).
/// in    nodes that form a forest (check_references)
/// cost  O(N); no recursion, so deep trees are no problem (G55)
JointOrder order_joints(const gltf::Document& document);

}  // namespace sinew
