// SPDX-License-Identifier: MIT
#include "importer/build/build_skeleton.h"

#include "importer/file/json_pointer.h"
#include "importer/read/animations.h"
#include "importer/read/nodes.h"

namespace sinew {

Skeleton build_skeleton(const gltf::Document& document, const JointOrder& order, const std::vector<bool>& animated,
                        IssueLog& log) {
  Skeleton skeleton;
  const std::size_t count = order.node_of_joint.size();
  skeleton.parents = order.parents;
  skeleton.node_of_joint = order.node_of_joint;
  skeleton.joint_of_node = order.joint_of_node;
  skeleton.level_begin = order.level_begin;
  skeleton.rest.reserve(count);
  skeleton.names.reserve(count);
  skeleton.fixed_matrix_of.assign(count, kNone);
  for (std::uint32_t joint = 0; joint < count; ++joint) {
    const std::uint32_t node = order.node_of_joint[joint];
    const NodeTransform local = read_node_transform(document.nodes[node], node, log);
    skeleton.rest.push_back(local.transform);
    skeleton.names.push_back(document.nodes[node].name);
    if (!local.is_matrix) continue;
    if (animated[node]) {
      log.report(Rule::node_matrix_animated, pointer("nodes", node, "matrix"),
                 "the node is animated; its matrix is decomposed");
      continue;
    }
    skeleton.fixed_matrix_of[joint] = static_cast<std::uint32_t>(skeleton.fixed_matrices.size());
    skeleton.fixed_matrices.push_back(local.matrix);
  }
  return skeleton;
}

std::vector<bool> find_animated_nodes(const gltf::Document& document) {
  std::vector<bool> animated(document.nodes.size(), false);
  IssueLog discarded_log;  // build_clips reports the issues of these channels
  for (std::uint32_t a = 0; a < document.animations.size(); ++a)
    for (std::uint32_t c = 0; c < document.animations[a].channels.size(); ++c) {
      const auto target = read_channel_target(document, a, c, discarded_log);
      if (target && target->moves_joint()) animated[target->node] = true;
    }
  return animated;
}

}  // namespace sinew
