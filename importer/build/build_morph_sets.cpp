// SPDX-License-Identifier: MIT
#include "importer/build/build_morph_sets.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "importer/read/morph_targets.h"
#include "runtime/math/negligible.h"

namespace sinew {
namespace {

/// Maps between file vertices and the vertices of a reordered primitive; empty = same order.
struct VertexOrder {
  std::span<const std::uint32_t> source;  ///< file vertex of each vertex
  std::vector<std::uint32_t> position;    ///< inverse: vertex of each file vertex

  explicit VertexOrder(std::span<const std::uint32_t> source_vertex)
      : source(source_vertex), position(source_vertex.size()) {
    for (std::uint32_t v = 0; v < source.size(); ++v) position[source[v]] = v;
  }
};

/// Sparse deltas from dense values. Counts non-zero values first, to allocate exactly.
template <class V>
SparseDeltas<V> sparse_of_all(const std::vector<V>& values, std::span<const std::uint32_t> source) {
  const auto moves = [](const V& delta) { return flushed(delta) != V(0.0f); };
  const auto count = static_cast<std::size_t>(std::count_if(values.begin(), values.end(), moves));
  SparseDeltas<V> out;
  out.vertices.reserve(count);
  out.deltas.reserve(count);
  for (std::uint32_t v = 0; v < values.size() && out.vertices.size() < count; ++v) {
    const V& value = values[source.empty() ? v : source[v]];
    if (!moves(value)) continue;
    out.vertices.push_back(v);
    out.deltas.push_back(flushed(value));
  }
  return out;
}

/// Sparse deltas from values with vertex indices.
template <class V>
SparseDeltas<V> sparse_of_named(Displacements<V> named, const VertexOrder& order) {
  if (!order.position.empty())
    for (auto& index : named.indices) index = order.position[index];
  const auto& vertices = named.indices;
  std::vector<std::uint32_t> by_vertex(vertices.size());
  std::iota(by_vertex.begin(), by_vertex.end(), 0u);
  const auto less = [&](std::uint32_t a, std::uint32_t b) { return vertices[a] < vertices[b]; };
  if (!std::is_sorted(vertices.begin(), vertices.end())) std::stable_sort(by_vertex.begin(), by_vertex.end(), less);
  SparseDeltas<V> out;
  out.vertices.reserve(vertices.size());
  out.deltas.reserve(vertices.size());
  for (std::size_t i = 0; i < by_vertex.size(); ++i) {
    const std::uint32_t entry = by_vertex[i];
    const bool replaced = i + 1 < by_vertex.size() && vertices[by_vertex[i + 1]] == vertices[entry];
    const V delta = flushed(named.values[entry]);
    if (replaced || delta == V(0.0f)) continue;
    out.vertices.push_back(vertices[entry]);
    out.deltas.push_back(delta);
  }
  return out;
}

template <class V>
SparseDeltas<V> sparse(Displacements<V> displacements, const VertexOrder& order) {
  if (displacements.indices.empty()) return sparse_of_all(displacements.values, order.source);
  return sparse_of_named(std::move(displacements), order);
}

}  // namespace

void build_morph_set(const gltf::Document& document, std::uint32_t mesh, std::uint32_t index, std::size_t target_count,
                     Primitive& primitive, IssueLog& log) {
  const std::size_t present = document.meshes[mesh].primitives[index].targets.size();
  primitive.morphs.targets.resize(target_count);
  const VertexOrder order(primitive.source_vertex);
  for (std::uint32_t t = 0; t < std::min(present, target_count) && primitive.vertex_count() > 0; ++t) {
    TargetData data = read_morph_target(document, mesh, index, t, primitive, log);
    MorphTarget& target = primitive.morphs.targets[t];
    target.positions = sparse(std::move(data.positions), order);
    target.normals = sparse(std::move(data.normals), order);
    target.tangents = sparse(std::move(data.tangents), order);
    target.colors = sparse(std::move(data.colors), order);
    for (auto& set : data.texcoords) target.texcoords.push_back(sparse(std::move(set), order));
  }
}

}  // namespace sinew
