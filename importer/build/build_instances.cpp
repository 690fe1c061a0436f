// SPDX-License-Identifier: MIT
#include "importer/build/build_instances.h"

#include <algorithm>
#include <string>

#include "importer/file/json_pointer.h"
#include "importer/read/mesh_copies.h"
#include "runtime/math/negligible.h"

namespace sinew {
namespace {

std::vector<float> rest_weights(const gltf::Node& node, std::uint32_t index, const Mesh& mesh, IssueLog& log) {
  if (node.weights.empty()) return mesh.default_weights;
  if (node.weights.size() != mesh.target_count())
    log.report(Rule::node_weights_count, pointer("nodes", index, "weights"),
               std::to_string(node.weights.size()) + " weights for " + std::to_string(mesh.target_count()) +
                   " targets; cut or filled with zeros");
  std::vector<float> weights(mesh.target_count(), 0.0f);
  for (std::size_t t = 0; t < std::min(weights.size(), node.weights.size()); ++t)
    weights[t] = flushed(static_cast<float>(node.weights[t]));
  return weights;
}

bool any_skinned(const Mesh& mesh) {
  return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                     [](const Primitive& p) { return !p.influences.empty(); });
}

}  // namespace

Instances build_instances(const gltf::Document& document, const JointOrder& order, const std::vector<Mesh>& meshes,
                          IssueLog& log) {
  Instances instances;
  instances.of_node.assign(document.nodes.size(), kNone);
  for (std::uint32_t n = 0; n < document.nodes.size(); ++n) {
    const gltf::Node& node = document.nodes[n];
    if (node.mesh == gltf::kAbsent) {
      if (node.skin != gltf::kAbsent)
        log.report(Rule::node_skin_without_mesh, pointer("nodes", n, "skin"), "the node has no mesh; ignored");
      if (!node.weights.empty())
        log.report(Rule::node_weights_count, pointer("nodes", n, "weights"), "the node has no mesh; ignored");
      continue;
    }
    auto copies = read_mesh_copies(document, n, log);
    if (copies && node.skin != gltf::kAbsent) {
      log.report(Rule::instancing_skin, pointer("nodes", n, "extensions", "EXT_mesh_gpu_instancing"),
                 "the mesh has a skin; shown once");
      copies.reset();
    }
    if (copies && copies->empty()) continue;
    const Mesh& mesh = meshes[node.mesh];
    MeshInstance instance{order.joint_of_node[n], static_cast<std::uint32_t>(node.mesh),
                          static_cast<std::uint32_t>(node.skin), rest_weights(node, n, mesh, log),
                          copies.value_or(std::vector<Transform>{})};
    if (node.skin != gltf::kAbsent && !any_skinned(mesh)) {
      log.report(Rule::node_skin_unused, pointer("nodes", n, "skin"),
                 "no primitive of the mesh has joints and weights; ignored");
      instance.skin = kNone;
    }
    instances.of_node[n] = static_cast<std::uint32_t>(instances.list.size());
    instances.list.push_back(std::move(instance));
  }
  return instances;
}

}  // namespace sinew
