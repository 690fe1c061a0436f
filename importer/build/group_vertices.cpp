// SPDX-License-Identifier: MIT
#include "importer/build/group_vertices.h"

#include <algorithm>
#include <numeric>

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
  const auto range = [&](const auto& from, auto& to) {
    to.insert(to.end(), from.begin() + merged.first[old], from.begin() + merged.first[old + 1]);
  };
  range(merged.joints, out.joints);
  range(merged.weights, out.weights);
}

}  // namespace

void group_vertices(Primitive& primitive, const MergedInfluences& merged) {
  if (merged.first.size() != primitive.vertex_count() + 1 || primitive.vertex_count() == 0) return;
  std::vector<std::uint32_t> source(primitive.vertex_count());
  std::iota(source.begin(), source.end(), 0u);
  std::stable_sort(source.begin(), source.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return count_of(merged, a) < count_of(merged, b); });
  std::vector<std::uint32_t> position(source.size());
  for (std::uint32_t v = 0; v < source.size(); ++v) {
    position[source[v]] = v;
    append_vertex(primitive.influences, merged, source[v], v);
  }
  permute(primitive.positions, source);
  permute(primitive.normals, source);
  permute(primitive.tangents, source);
  for (auto& set : primitive.texcoords) permute(set, source);
  permute(primitive.colors, source);
  for (auto& index : primitive.indices) index = position[index];
  if (!std::is_sorted(source.begin(), source.end())) primitive.source_vertex = std::move(source);
}

}  // namespace sinew
