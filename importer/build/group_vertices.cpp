// SPDX-License-Identifier: MIT
#include "importer/build/group_vertices.h"

#include <algorithm>
#include <utility>

#include "importer/topology/gather_vertices.h"

namespace sinew {
namespace {

std::uint32_t count_of(const MergedInfluences& merged, std::uint32_t vertex) {
  return merged.first[vertex + 1] - merged.first[vertex];
}

void add_group(VertexInfluences& out, std::uint32_t count, std::uint32_t position, std::uint32_t first_entry) {
  if (out.groups.empty() || out.groups.back().influence_count != count)
    out.groups.push_back({position, 0, count, first_entry});
  ++out.groups.back().vertex_count;
}

/// Moves the lists when the vertices are in order already, else copies them vertex by vertex.
void fill_influences(VertexInfluences& out, MergedInfluences merged, const std::vector<std::uint32_t>& source,
                     bool in_order) {
  std::uint32_t entry = 0;
  for (std::uint32_t v = 0; v < source.size(); ++v) {
    const std::uint32_t count = count_of(merged, source[v]);
    add_group(out, count, v, entry);
    entry += count;
  }
  if (in_order) {
    out.joints = std::move(merged.joints);
    out.weights = std::move(merged.weights);
    return;
  }
  out.joints.resize(merged.joints.size());
  out.weights.resize(merged.weights.size());
  auto joint = out.joints.begin();
  auto weight = out.weights.begin();
  for (const std::uint32_t old : source)
    for (std::uint32_t i = merged.first[old]; i < merged.first[old + 1]; ++i) {
      *joint++ = merged.joints[i];
      *weight++ = merged.weights[i];
    }
}

/// Sorts vertices by their number of influences with a stable counting sort.
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

void group_vertices(Primitive& primitive, MergedInfluences merged) {
  const std::size_t vertices = primitive.vertex_count();
  if (merged.first.size() != vertices + 1 || vertices == 0) return;
  const std::vector<std::uint32_t> source = sorted_by_count(merged, vertices);
  const bool in_order = std::is_sorted(source.begin(), source.end());
  if (!in_order) permute_vertices(primitive, source);
  fill_influences(primitive.influences, std::move(merged), source, in_order);
}

}  // namespace sinew
