// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/issue_log.h"
#include "runtime/model/scene.h"

namespace sinew {

/// One instance per node with a mesh, in node order; none for a node that has instances of its own, but none at all.
struct Instances {
  std::vector<MeshInstance> list;
  std::vector<std::uint32_t> of_node;  ///< [N] instance of each node, kNone without a mesh
};

/// Weights are node.weights, else mesh.weights, else zeros (G43). A skin on a mesh without joints is ignored.
/// err  those of read_mesh_copies; the mesh is shown once then
/// warning node-weights-count, node-skin-without-mesh, node-skin-unused, instancing-skin
Instances build_instances(const gltf::Document& document, const JointOrder& order, const std::vector<Mesh>& meshes,
                          IssueLog& log);

}  // namespace sinew
