// SPDX-License-Identifier: MIT
#include "importer/build/group_vertices.h"

#include <algorithm>

namespace sinew {
namespace {

template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& source) {
  if (values.empty()) return;
  std::vector<T> out;
  out.reserve(values.size());
  for (const std::uint32_t old : source) out.push_back(values[old]);
  values = std::move(out);
}

std::uint32_t count_of(const MergedInfluences& merged, std::uint32_t vertex) {
  return merged.first[vertex + 1] - merged.first[vertex];
}

void append_vertex(VertexInfluences& out, const MergedInfluences& merged, std::uint32_t old, std::uint32_t position) {
  const std::uint32_t count = count_of(merged, old);
  if (out.groups.empty() || out.groups.back().influence_count != count)
    out.groups.push_back({position, 0, count, static_cast<std::uint32_t>(out.joints.size())});
  ++out.groups.back().vertex_count;
  for (std::uint32_t i = merged.first[old]; i < merged.first[old + 1]; ++i) {
    out.joints.push_back(merged.joints[i]);
    out.weights.push_back(merged.weights[i]);
  }
}

/// Vertices by rising number of influences, those of equal number in their order: a counting sort.
std::vector<std::uint32_t> sorted_by_count(const MergedInfluences& merged, std::size_t vertex_count) {
  std::vector<std::uint32_t> next;  // per number of influences: where its next vertex goes
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const std::uint32_t count = count_of(merged, v);
    if (next.size() < count + 2) next.resize(count + 2, 0);
    ++next[count + 1];
  }
  for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
  std::vector<std::uint32_t> source(vertex_count);
  for (std::uint32_t v = 0; v < vertex_count; ++v) source[next[count_of(merged, v)]++] = v;
  return source;
}

}  // namespace

void group_vertices(Primitive& primitive, const MergedInfluences& merged) {
  const std::size_t vertices = primitive.vertex_count();
  if (merged.first.size() != vertices + 1 || vertices == 0) return;
  std::vector<std::uint32_t> source = sorted_by_count(merged, vertices);
  primitive.influences.joints.reserve(merged.joints.size());
  primitive.influences.weights.reserve(merged.weights.size());
  for (std::uint32_t v = 0; v < vertices; ++v) append_vertex(primitive.influences, merged, source[v], v);
  if (std::is_sorted(source.begin(), source.end())) return;

  std::vector<std::uint32_t> position(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) position[source[v]] = v;
  permute(primitive.positions, source);
  permute(primitive.normals, source);
  permute(primitive.tangents, source);
  for (auto& set : primitive.texcoords) permute(set, source);
  permute(primitive.colors, source);
  for (auto& index : primitive.indices) index = position[index];
  primitive.source_vertex = std::move(source);
}

}  // namespace sinew
