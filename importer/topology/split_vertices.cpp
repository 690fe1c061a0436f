// SPDX-License-Identifier: MIT
#include "importer/topology/split_vertices.h"

#include <algorithm>
#include <vector>

#include "runtime/base/contract.h"

namespace sinew {
namespace {

/// The copies of each old vertex v are first[v] .. first[v + 1] - 1.
struct Copies {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> old_of_new;
  std::vector<std::uint32_t> new_of_corner;
};

/// The corners of each vertex v, rising: corners[begin[v] .. begin[v + 1] - 1].
struct CornersOfVertex {
  std::vector<std::uint32_t> begin, corners;

  explicit CornersOfVertex(const Primitive& p) : begin(p.vertex_count() + 1, 0), corners(p.indices.size()) {
    for (const std::uint32_t v : p.indices) ++begin[v + 1];
    for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t c = 0; c < corners.size(); ++c) corners[next[p.indices[c]]++] = static_cast<std::uint32_t>(c);
  }
};

Copies plan_copies(const Primitive& primitive, std::span<const std::uint32_t> group) {
  CornersOfVertex sorted(primitive);
  Copies copies;
  copies.new_of_corner.resize(group.size());
  for (std::size_t v = 0; v < primitive.vertex_count(); ++v) {
    const std::span corners = std::span(sorted.corners).subspan(sorted.begin[v], sorted.begin[v + 1] - sorted.begin[v]);
    std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) { return group[a] < group[b]; });
    copies.first.push_back(static_cast<std::uint32_t>(copies.old_of_new.size()));
    copies.old_of_new.push_back(static_cast<std::uint32_t>(v));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const bool another = i > 0 && group[corners[i]] != group[corners[i - 1]] && group[corners[i]] != kNone;
      if (another) copies.old_of_new.push_back(static_cast<std::uint32_t>(v));
      copies.new_of_corner[corners[i]] = static_cast<std::uint32_t>(copies.old_of_new.size() - 1);
    }
  }
  copies.first.push_back(static_cast<std::uint32_t>(copies.old_of_new.size()));
  return copies;
}

template <class V>
void gather(std::vector<V>& values, const Copies& copies) {
  if (values.empty()) return;
  std::vector<V> result;
  result.reserve(copies.old_of_new.size());
  for (const std::uint32_t v : copies.old_of_new) result.push_back(values[v]);
  values = std::move(result);
}

template <class V>
void gather(SparseDeltas<V>& deltas, const Copies& copies) {
  SparseDeltas<V> result;
  for (std::size_t i = 0; i < deltas.vertices.size(); ++i) {
    const std::uint32_t v = deltas.vertices[i];
    for (std::uint32_t n = copies.first[v]; n < copies.first[v + 1]; ++n) {
      result.vertices.push_back(n);
      result.deltas.push_back(deltas.deltas[i]);
    }
  }
  deltas = std::move(result);
}

void gather(VertexInfluences& influences, const Copies& copies) {
  VertexInfluences result;
  for (const InfluenceGroup& group : influences.groups) {
    const std::uint32_t end = group.first_vertex + group.vertex_count;
    InfluenceGroup grown = group;
    grown.first_vertex = copies.first[group.first_vertex];
    grown.vertex_count = copies.first[end] - grown.first_vertex;
    grown.first_influence = static_cast<std::uint32_t>(result.joints.size());
    for (std::uint32_t n = grown.first_vertex; n < copies.first[end]; ++n) {
      const std::size_t from =
          group.first_influence + std::size_t{group.influence_count} * (copies.old_of_new[n] - group.first_vertex);
      for (std::size_t k = from; k < from + group.influence_count; ++k) {
        result.joints.push_back(influences.joints[k]);
        result.weights.push_back(influences.weights[k]);
      }
    }
    result.groups.push_back(grown);
  }
  influences = std::move(result);
}

}  // namespace

void split_vertices(Primitive& primitive, std::span<const std::uint32_t> group) {
  CONTRACT(group.size() == primitive.indices.size());
  const Copies copies = plan_copies(primitive, group);
  if (copies.old_of_new.size() == primitive.vertex_count()) return;

  primitive.indices = copies.new_of_corner;
  if (primitive.source_vertex.empty())
    primitive.source_vertex = copies.old_of_new;
  else
    gather(primitive.source_vertex, copies);

  gather(primitive.positions, copies);
  gather(primitive.normals, copies);
  gather(primitive.tangents, copies);
  for (auto& set : primitive.texcoords) gather(set, copies);
  gather(primitive.colors, copies);
  gather(primitive.influences, copies);
  for (MorphTarget& target : primitive.morphs.targets) {
    gather(target.positions, copies);
    gather(target.normals, copies);
    gather(target.tangents, copies);
    gather(target.colors, copies);
    for (auto& set : target.texcoords) gather(set, copies);
  }
}

}  // namespace sinew
