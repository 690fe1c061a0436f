// SPDX-License-Identifier: MIT
#include "importer/topology/gather_vertices.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace sinew {
namespace {

using OldOfNew = std::span<const std::uint32_t>;

/// The new vertices of each old vertex v, in increasing order: vertices[begin[v] .. begin[v + 1] - 1].
struct NewOfOld {
  std::vector<std::uint32_t> begin, vertices;

  NewOfOld(OldOfNew old_of_new, std::size_t old_count) : begin(old_count + 1, 0), vertices(old_of_new.size()) {
    for (const std::uint32_t old : old_of_new) ++begin[old + 1];
    for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t n = 0; n < old_of_new.size(); ++n) vertices[next[old_of_new[n]]++] = n;
  }
};

template <class V>
void gather(std::vector<V>& values, OldOfNew old_of_new) {
  if (values.empty()) return;
  std::vector<V> result;
  result.reserve(old_of_new.size());
  for (const std::uint32_t old : old_of_new) result.push_back(values[old]);
  values = std::move(result);
}

template <class V>
void gather(SparseDeltas<V>& deltas, const NewOfOld& new_of_old) {
  std::vector<std::pair<std::uint32_t, V>> entries;
  for (std::size_t i = 0; i < deltas.vertices.size(); ++i) {
    const std::uint32_t old = deltas.vertices[i];
    for (std::uint32_t at = new_of_old.begin[old]; at < new_of_old.begin[old + 1]; ++at)
      entries.emplace_back(new_of_old.vertices[at], deltas.deltas[i]);
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  deltas = {};
  for (const auto& [vertex, delta] : entries) {
    deltas.vertices.push_back(vertex);
    deltas.deltas.push_back(delta);
  }
}

void gather(VertexInfluences& influences, OldOfNew old_of_new) {
  VertexInfluences result;
  std::uint32_t n = 0;
  for (const InfluenceGroup& group : influences.groups) {
    InfluenceGroup grown = group;
    grown.first_vertex = n;
    grown.first_influence = static_cast<std::uint32_t>(result.joints.size());
    for (; n < old_of_new.size() && old_of_new[n] - group.first_vertex < group.vertex_count; ++n) {
      const std::size_t from =
          group.first_influence + std::size_t{group.influence_count} * (old_of_new[n] - group.first_vertex);
      for (std::size_t k = from; k < from + group.influence_count; ++k) {
        result.joints.push_back(influences.joints[k]);
        result.weights.push_back(influences.weights[k]);
      }
    }
    grown.vertex_count = n - grown.first_vertex;
    result.groups.push_back(grown);
  }
  influences = std::move(result);
}

}  // namespace

void gather_vertices(Primitive& primitive, std::span<const std::uint32_t> old_of_new) {
  const std::size_t old_count = primitive.vertex_count();
  if (primitive.source_vertex.empty())
    primitive.source_vertex.assign(old_of_new.begin(), old_of_new.end());
  else
    gather(primitive.source_vertex, old_of_new);

  gather(primitive.positions, old_of_new);
  gather(primitive.normals, old_of_new);
  gather(primitive.tangents, old_of_new);
  for (auto& set : primitive.texcoords) gather(set, old_of_new);
  gather(primitive.colors, old_of_new);
  gather(primitive.influences, old_of_new);
  if (primitive.morphs.empty()) return;
  const NewOfOld new_of_old(old_of_new, old_count);
  for (MorphTarget& target : primitive.morphs.targets) {
    gather(target.positions, new_of_old);
    gather(target.normals, new_of_old);
    gather(target.tangents, new_of_old);
    gather(target.colors, new_of_old);
    for (auto& set : target.texcoords) gather(set, new_of_old);
  }
}

void permute_vertices(Primitive& primitive, std::span<const std::uint32_t> old_of_new) {
  gather_vertices(primitive, old_of_new);
  std::vector<std::uint32_t> new_of_old(old_of_new.size());
  for (std::uint32_t n = 0; n < old_of_new.size(); ++n) new_of_old[old_of_new[n]] = n;
  for (std::uint32_t& index : primitive.indices) index = new_of_old[index];
}

}  // namespace sinew
