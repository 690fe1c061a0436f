// SPDX-License-Identifier: MIT
#include "importer/tool/info/skin_statistics.h"

#include <algorithm>
#include <set>
#include <vector>

namespace sinew::tool {
namespace {

/// [V] true for the first copy of each vertex of the file.
std::vector<bool> first_copies(const Primitive& primitive) {
  std::vector<bool> first(primitive.vertex_count(), true);
  const auto& source = primitive.source_vertex;
  std::vector<bool> seen(source.empty() ? 0 : std::size_t{*std::max_element(source.begin(), source.end())} + 1, false);
  for (std::size_t v = 0; v < source.size(); ++v) {
    first[v] = !seen[source[v]];
    seen[source[v]] = true;
  }
  return first;
}

void count(const Primitive& primitive, SkinStatistics& out, std::set<std::uint16_t>& joints) {
  const auto first = first_copies(primitive);
  for (const InfluenceGroup& group : primitive.influences.groups)
    for (std::uint32_t v = group.first_vertex; v < group.first_vertex + group.vertex_count; ++v)
      if (first[v]) ++out.vertices_by_influences[group.influence_count];
  joints.insert(primitive.influences.joints.begin(), primitive.influences.joints.end());
}

}  // namespace

SkinStatistics skin_statistics(const Scene& scene, std::uint32_t skin) {
  std::set<std::uint32_t> meshes;
  for (const MeshInstance& instance : scene.instances)
    if (instance.skin == skin) meshes.insert(instance.mesh);
  SkinStatistics out;
  std::set<std::uint16_t> joints;
  for (const std::uint32_t mesh : meshes)
    for (const Primitive& primitive : scene.meshes[mesh].primitives) count(primitive, out, joints);
  out.joints_with_weight = joints.size();
  return out;
}

std::uint64_t file_vertex_count(const Primitive& primitive) {
  const auto first = first_copies(primitive);
  return static_cast<std::uint64_t>(std::count(first.begin(), first.end(), true));
}

}  // namespace sinew::tool
