// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "importer/write/write_scene.h"

namespace sinew::write {
namespace {

int mode_of(Topology topology) {
  switch (topology) {
    case Topology::points: return TINYGLTF_MODE_POINTS;
    case Topology::lines: return TINYGLTF_MODE_LINE;
    case Topology::triangles: break;
  }
  return TINYGLTF_MODE_TRIANGLES;
}

/// JOINTS_n and WEIGHTS_n take four influences a set; vertices with fewer are filled up with weight 0.
void write_influences(const Primitive& primitive, tinygltf::Primitive& out, GlbBuffer& buffer) {
  std::uint32_t most = 0;
  for (const auto& group : primitive.influences.groups) most = std::max(most, group.influence_count);
  for (std::uint32_t set = 0; set * 4 < most; ++set) {
    std::vector<std::uint16_t> joints(4 * primitive.vertex_count(), 0);
    std::vector<glm::vec4> weights(primitive.vertex_count(), glm::vec4(0.0f));
    for (const auto& group : primitive.influences.groups)
      for (std::uint32_t v = 0; v < group.vertex_count; ++v)
        for (std::uint32_t i = set * 4; i < std::min(group.influence_count, set * 4 + 4); ++i) {
          const std::size_t from = group.first_influence + std::size_t{v} * group.influence_count + i;
          const std::size_t vertex = group.first_vertex + v;
          joints[4 * vertex + i % 4] = primitive.influences.joints[from];
          weights[vertex][static_cast<int>(i % 4)] = primitive.influences.weights[from];
        }
    out.attributes["JOINTS_" + std::to_string(set)] = buffer.add_joints(joints);
    out.attributes["WEIGHTS_" + std::to_string(set)] = buffer.add(std::span<const glm::vec4>(weights));
  }
}

void write_targets(const Primitive& primitive, tinygltf::Primitive& out, GlbBuffer& buffer) {
  const std::size_t count = primitive.vertex_count();
  for (const auto& target : primitive.morphs.targets) {
    std::map<std::string, int> attributes;
    attributes["POSITION"] = buffer.add_deltas(target.positions, count, true);
    if (!target.normals.empty() && !primitive.flat_normals) attributes["NORMAL"] = buffer.add_deltas(target.normals, count);
    if (!target.tangents.empty()) attributes["TANGENT"] = buffer.add_deltas(target.tangents, count);
    if (!target.colors.empty()) attributes["COLOR_0"] = buffer.add_deltas(target.colors, count);
    for (std::size_t n = 0; n < target.texcoords.size(); ++n)
      if (!target.texcoords[n].empty()) attributes["TEXCOORD_" + std::to_string(n)] = buffer.add_deltas(target.texcoords[n], count);
    out.targets.push_back(std::move(attributes));
  }
}

tinygltf::Primitive written(const Primitive& primitive, GlbBuffer& buffer) {
  tinygltf::Primitive out;
  out.mode = mode_of(primitive.topology);
  if (primitive.material != kNone) out.material = static_cast<int>(primitive.material);
  out.attributes["POSITION"] = buffer.add(std::span<const glm::vec3>(primitive.positions), true);
  if (!primitive.normals.empty() && !primitive.flat_normals)
    out.attributes["NORMAL"] = buffer.add(std::span<const glm::vec3>(primitive.normals));
  if (!primitive.tangents.empty()) out.attributes["TANGENT"] = buffer.add(std::span<const glm::vec4>(primitive.tangents));
  for (std::size_t n = 0; n < primitive.texcoords.size(); ++n)
    out.attributes["TEXCOORD_" + std::to_string(n)] = buffer.add(std::span<const glm::vec2>(primitive.texcoords[n]));
  if (!primitive.colors.empty()) out.attributes["COLOR_0"] = buffer.add(std::span<const glm::vec4>(primitive.colors));
  if (!primitive.influences.empty()) write_influences(primitive, out, buffer);
  write_targets(primitive, out, buffer);
  out.indices = buffer.add_indices(primitive.indices);
  return out;
}

}  // namespace

void write_meshes(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer) {
  for (const auto& mesh : scene.meshes) {
    tinygltf::Mesh out;
    out.name = mesh.name;
    out.weights.assign(mesh.default_weights.begin(), mesh.default_weights.end());
    for (const auto& primitive : mesh.primitives) out.primitives.push_back(written(primitive, buffer));
    if (!mesh.target_names.empty()) {
      tinygltf::Value::Array names;
      for (const auto& name : mesh.target_names) names.emplace_back(name);
      out.extras = tinygltf::Value(tinygltf::Value::Object{{"targetNames", tinygltf::Value(std::move(names))}});
    }
    model.meshes.push_back(std::move(out));
  }
}

}  // namespace sinew::write
