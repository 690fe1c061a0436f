// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew::write {

/// Which vertices of a primitive are written, and in which order. The order is that of the file that the primitive came
/// from, so that vertex numbers survive and a later import groups and splits the vertices in the same way.
struct FileVertices {
  std::vector<std::uint32_t> scene_vertex;  ///< [written] the primitive's vertex behind each written vertex
  std::vector<std::uint32_t> file_vertex;   ///< [V] where each vertex of the primitive is written

  std::size_t count() const noexcept { return scene_vertex.size(); }

  /// Values of the primitive's vertices, in the order in which they are written.
  template <class T>
  std::vector<T> gather(const std::vector<T>& values) const {
    std::vector<T> out;
    out.reserve(count());
    for (const std::uint32_t v : scene_vertex) out.push_back(values[v]);
    return out;
  }

  /// The same for displacements. Of several copies of a vertex the first counts.
  template <class T>
  SparseDeltas<T> gather(const SparseDeltas<T>& deltas) const {
    std::vector<T> dense(count(), T(0.0f));
    for (std::size_t i = deltas.vertices.size(); i-- > 0;) dense[file_vertex[deltas.vertices[i]]] = deltas.deltas[i];
    SparseDeltas<T> out;
    for (std::uint32_t v = 0; v < dense.size(); ++v)
      if (dense[v] != T(0.0f)) {
        out.vertices.push_back(v);
        out.deltas.push_back(dense[v]);
      }
    return out;
  }
};

/// Chooses the vertices. Copies that the importer made for flat normals are written once, because flat normals are not
/// written. The order of the scene is kept where `source_vertex` is empty or has gaps, or where copies differ
/// otherwise.
/// cost O(V)
FileVertices file_vertices(const Primitive& primitive);

}  // namespace sinew::write
