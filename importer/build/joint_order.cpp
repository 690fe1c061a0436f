// SPDX-License-Identifier: MIT
#include "importer/build/joint_order.h"

namespace sinew {

JointOrder order_joints(const gltf::Document& document) {
  const std::size_t count = document.nodes.size();
  JointOrder order;
  order.joint_of_node.assign(count, kNone);
  order.root_of_node.assign(count, kNone);
  order.node_of_joint.reserve(count);
  order.parents.reserve(count);
  std::vector<bool> has_parent(count, false);
  for (const auto& node : document.nodes)
    for (const std::uint32_t child : node.children) has_parent[child] = true;

  const auto append = [&](std::uint32_t node, std::uint32_t parent_joint, std::uint32_t root) {
    order.joint_of_node[node] = static_cast<std::uint32_t>(order.node_of_joint.size());
    order.root_of_node[node] = root;
    order.node_of_joint.push_back(node);
    order.parents.push_back(parent_joint);
  };
  for (std::uint32_t n = 0; n < count; ++n)
    if (!has_parent[n]) append(n, kNone, n);

  for (std::uint32_t begin = 0; begin < order.node_of_joint.size();) {
    order.level_begin.push_back(begin);
    const auto end = static_cast<std::uint32_t>(order.node_of_joint.size());
    for (std::uint32_t joint = begin; joint < end; ++joint) {
      const std::uint32_t node = order.node_of_joint[joint];
      for (const std::uint32_t child : document.nodes[node].children) append(child, joint, order.root_of_node[node]);
    }
    begin = end;
  }
  order.level_begin.push_back(static_cast<std::uint32_t>(order.node_of_joint.size()));
  return order;
}

}  // namespace sinew
