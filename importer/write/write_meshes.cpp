// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <string>

#include "importer/write/file_vertices.h"
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

/// Range of a vertex's influences in the lists of its primitive.
struct InfluenceRange {
  std::size_t first = 0;
  std::uint32_t count = 0;
};

std::vector<InfluenceRange> influence_ranges(const VertexInfluences& influences) {
  std::vector<InfluenceRange> ranges;
  for (const auto& group : influences.groups)
    for (std::uint32_t v = 0; v < group.vertex_count; ++v)
      ranges.push_back({group.first_influence + std::size_t{v} * group.influence_count, group.influence_count});
  return ranges;
}

/// Writes influences as JOINTS_n / WEIGHTS_n sets of four; missing ones get weight 0.
void write_influences(const Primitive& primitive, const FileVertices& vertices, tinygltf::Primitive& out,
                      GlbBuffer& buffer) {
  const auto ranges = vertices.gather(influence_ranges(primitive.influences));
  std::uint32_t most = 0;
  for (const auto& range : ranges) most = std::max(most, range.count);
  for (std::uint32_t set = 0; set * 4 < most; ++set) {
    std::vector<std::uint16_t> joints(4 * ranges.size(), 0);
    std::vector<glm::vec4> weights(ranges.size(), glm::vec4(0.0f));
    for (std::size_t v = 0; v < ranges.size(); ++v)
      for (std::uint32_t i = set * 4; i < std::min(ranges[v].count, set * 4 + 4); ++i) {
        joints[4 * v + i % 4] = primitive.influences.joints[ranges[v].first + i];
        weights[v][static_cast<int>(i % 4)] = primitive.influences.weights[ranges[v].first + i];
      }
    out.attributes["JOINTS_" + std::to_string(set)] = buffer.add_joints(joints);
    out.attributes["WEIGHTS_" + std::to_string(set)] = buffer.add(std::span<const glm::vec4>(weights));
  }
}

void write_targets(const Primitive& primitive, const FileVertices& vertices, tinygltf::Primitive& out,
                   GlbBuffer& buffer) {
  const std::size_t count = vertices.count();
  for (const auto& target : primitive.morphs.targets) {
    std::map<std::string, int> attributes;
    attributes["POSITION"] = buffer.add_deltas(vertices.gather(target.positions), count, true);
    if (!target.normals.empty() && !primitive.flat_normals)
      attributes["NORMAL"] = buffer.add_deltas(vertices.gather(target.normals), count);
    if (!target.tangents.empty()) attributes["TANGENT"] = buffer.add_deltas(vertices.gather(target.tangents), count);
    if (!target.colors.empty()) attributes["COLOR_0"] = buffer.add_deltas(vertices.gather(target.colors), count);
    for (std::size_t n = 0; n < target.texcoords.size(); ++n)
      if (!target.texcoords[n].empty())
        attributes["TEXCOORD_" + std::to_string(n)] = buffer.add_deltas(vertices.gather(target.texcoords[n]), count);
    out.targets.push_back(std::move(attributes));
  }
}

void write_vertices(const Primitive& primitive, const FileVertices& vertices, tinygltf::Primitive& out,
                    GlbBuffer& buffer) {
  const auto add = [&](const char* name, const auto& values, auto... with_bounds) {
    if (values.empty()) return;
    const auto ordered = vertices.gather(values);
    out.attributes[name] = buffer.add(std::span(ordered), with_bounds...);
  };
  add("POSITION", primitive.positions, true);
  if (!primitive.flat_normals) add("NORMAL", primitive.normals);
  add("TANGENT", primitive.tangents);
  for (std::size_t n = 0; n < primitive.texcoords.size(); ++n)
    add(("TEXCOORD_" + std::to_string(n)).c_str(), primitive.texcoords[n]);
  add("COLOR_0", primitive.colors);
}

/// Writes an empty primitive, to keep its index. glTF requires at least one attribute, and as many targets as the
/// mesh's other primitives.
void write_nothing(const Primitive& primitive, tinygltf::Primitive& out, GlbBuffer& buffer) {
  constexpr float kOne[] = {0.0f};
  const std::map<std::string, int> nothing{{"_EMPTY", buffer.add(std::span<const float>(kOne))}};
  out.attributes = nothing;
  out.targets.assign(primitive.morphs.targets.size(), nothing);
}

tinygltf::Primitive written(const Primitive& primitive, GlbBuffer& buffer) {
  tinygltf::Primitive out;
  out.mode = mode_of(primitive.topology);
  if (primitive.material != kNone) out.material = static_cast<int>(primitive.material);
  if (primitive.positions.empty() || (primitive.topology == Topology::points && primitive.indices.empty())) {
    write_nothing(primitive, out, buffer);
    return out;
  }
  const FileVertices vertices = file_vertices(primitive);
  write_vertices(primitive, vertices, out, buffer);
  if (!primitive.influences.empty()) write_influences(primitive, vertices, out, buffer);
  write_targets(primitive, vertices, out, buffer);
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t v : primitive.indices) indices.push_back(vertices.file_vertex[v]);
  if (indices.empty()) indices.push_back(0);  // glTF forbids an empty list; a single index draws no line or triangle
  out.indices = buffer.add_indices(indices);
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
