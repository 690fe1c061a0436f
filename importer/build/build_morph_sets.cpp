// SPDX-License-Identifier: MIT
#include "importer/build/build_morph_sets.h"

#include <algorithm>
#include <vector>

#include "importer/read/morph_targets.h"
#include "runtime/math/negligible.h"

namespace sinew {
namespace {

/// `dense` is in the file's order, source[v] is the file's vertex of vertex v (empty = unchanged).
template <class V>
SparseDeltas<V> sparse(const std::vector<V>& dense, const std::vector<std::uint32_t>& source) {
  SparseDeltas<V> out;
  for (std::uint32_t v = 0; v < dense.size(); ++v) {
    const V delta = flushed(dense[source.empty() ? v : source[v]]);
    if (delta == V(0.0f)) continue;
    out.vertices.push_back(v);
    out.deltas.push_back(delta);
  }
  return out;
}

}  // namespace

void build_morph_set(const gltf::Document& document, std::uint32_t mesh, std::uint32_t index, std::size_t target_count,
                     Primitive& primitive, IssueLog& log) {
  const std::size_t present = document.meshes[mesh].primitives[index].targets.size();
  primitive.morphs.targets.resize(target_count);
  for (std::uint32_t t = 0; t < std::min(present, target_count) && primitive.vertex_count() > 0; ++t) {
    const DenseTarget dense = read_morph_target(document, mesh, index, t, primitive, log);
    MorphTarget& target = primitive.morphs.targets[t];
    const auto& source = primitive.source_vertex;
    target.positions = sparse(dense.positions, source);
    target.normals = sparse(dense.normals, source);
    target.tangents = sparse(dense.tangents, source);
    target.colors = sparse(dense.colors, source);
    for (const auto& set : dense.texcoords) target.texcoords.push_back(sparse(set, source));
  }
}

}  // namespace sinew
