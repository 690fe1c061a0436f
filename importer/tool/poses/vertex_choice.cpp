// SPDX-License-Identifier: MIT
#include "importer/tool/poses/vertex_choice.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace sinew::tool {
namespace {

/// Pairs of (vertex of the file, first vertex of the primitive that stands for it), increasing.
std::vector<std::pair<std::uint32_t, std::uint32_t>> file_vertices(const Primitive& primitive) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs(primitive.vertex_count());
  for (std::uint32_t v = 0; v < pairs.size(); ++v)
    pairs[v] = {primitive.source_vertex.empty() ? v : primitive.source_vertex[v], v};
  std::sort(pairs.begin(), pairs.end());
  const auto same_vertex = [](const auto& a, const auto& b) { return a.first == b.first; };
  pairs.erase(std::unique(pairs.begin(), pairs.end(), same_vertex), pairs.end());
  return pairs;
}

VertexChoice::Influences influences_of(const VertexInfluences& all, std::uint32_t vertex) {
  const auto after = std::upper_bound(all.groups.begin(), all.groups.end(), vertex,
                                      [](std::uint32_t v, const InfluenceGroup& g) { return v < g.first_vertex; });
  const InfluenceGroup& group = *std::prev(after);
  return {group.first_influence + (vertex - group.first_vertex) * group.influence_count, group.influence_count};
}

}  // namespace

VertexChoice choose_vertices(const Primitive& primitive, std::size_t limit) {
  const auto pairs = file_vertices(primitive);
  const std::size_t count = std::min(limit, pairs.size());
  VertexChoice choice;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [file, own] = pairs[count == 1 ? 0 : i * (pairs.size() - 1) / (count - 1)];
    choice.in_file.push_back(file);
    choice.in_primitive.push_back(own);
    if (!primitive.influences.empty()) choice.influences.push_back(influences_of(primitive.influences, own));
  }
  return choice;
}

}  // namespace sinew::tool
