// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew::write {

/// Selection and order of the vertices of a primitive in a written file. It restores the order of the source file, so
/// that vertex numbers survive and a later import groups and splits vertices in the same way.
struct FileVertices {
  std::vector<std::uint32_t> scene_vertex;  ///< [written] primitive's vertex of each written vertex
  std::vector<std::uint32_t> file_vertex;   ///< [V] written vertex of each vertex of the primitive

  std::size_t count() const noexcept { return scene_vertex.size(); }

  /// Reorders values of the primitive's vertices to the written order.
  template <class T>
  std::vector<T> gather(const std::vector<T>& values) const {
    std::vector<T> out;
    out.reserve(count());
    for (const std::uint32_t v : scene_vertex) out.push_back(values[v]);
    return out;
  }

  /// Reorders displacements. Of several copies of a vertex, the first is used.
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

/// Chooses the vertices. Copies made by the importer for flat normals are written once, because flat normals are not
/// written. Keeps the scene order if `source_vertex` is empty or has gaps, or if copies differ in other attributes.
/// cost O(V)
FileVertices file_vertices(const Primitive& primitive);

}  // namespace sinew::write
