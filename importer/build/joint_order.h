// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/file/document.h"

namespace sinew {

/// The nodes of a document in skeleton order: breadth-first, roots first, children in file order.
struct JointOrder {
  std::vector<std::uint32_t> node_of_joint;  ///< [N] node of each joint
  std::vector<std::uint32_t> joint_of_node;  ///< [N] joint of each node
  std::vector<std::uint32_t> parents;        ///< [N] joint of the parent, kNone for a root
  std::vector<std::uint32_t> level_begin;    ///< [depth + 1] first joint of each depth, last entry = N
  std::vector<std::uint32_t> root_of_node;   ///< [N] root of each node's tree
};

/// Orders all nodes, including those in no scene, because skins and clips may use any node.
/// in    nodes form a forest (check_references)
/// cost  O(N); not recursive, so deep trees cannot overflow the stack
JointOrder order_joints(const gltf::Document& document);

}  // namespace sinew
