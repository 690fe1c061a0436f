// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/issue_log.h"
#include "runtime/model/scene.h"

namespace sinew {

/// One mesh instance for each node with a mesh, in node order. A node whose EXT_mesh_gpu_instancing has zero copies
/// gets no instance.
struct Instances {
  std::vector<MeshInstance> list;
  std::vector<std::uint32_t> of_node;  ///< [N] instance of each node; kNone = none
};

/// Builds the instances. Rest weights are node.weights, else mesh.weights, else zeros. A skin on a mesh without joints
/// and weights is ignored.
/// err      as read_mesh_copies; the mesh is then shown once
/// warning  node-weights-count, node-skin-without-mesh, node-skin-unused, instancing-skin
Instances build_instances(const gltf::Document& document, const JointOrder& order, const std::vector<Mesh>& meshes,
                          IssueLog& log);

}  // namespace sinew
