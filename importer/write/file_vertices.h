// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew::write {

/// Which vertices of a primitive are written, and in which order: those of the file that it came from, so that vertex
/// numbers survive and reading again groups and splits them in the same way.
struct FileVertices {
  std::vector<std::uint32_t> scene_vertex;  ///< [written] the vertex of the primitive that each written one is
  std::vector<std::uint32_t> file_vertex;   ///< [V] where each vertex of the primitive is written

  std::size_t count() const noexcept { return scene_vertex.size(); }

  /// Values of the primitive's vertices in the order in which they are written.
  template <class T>
  std::vector<T> gather(const std::vector<T>& values) const {
    std::vector<T> out;
    out.reserve(count());
    for (const std::uint32_t v : scene_vertex) out.push_back(values[v]);
    return out;
  }

  /// The same for displacements; of copies the first counts.
  template <class T>
  SparseDeltas<T> gather(const SparseDeltas<T>& deltas) const {
    std::vector<T> dense(count(), T(0.0f));
    for (std::size_t i = deltas.vertices.size(); i-- > 0;) dense[file_vertex[deltas.vertices[i]]] = deltas.deltas[i];
    SparseDeltas<T> out;
    for (std::uint32_t v = 0; v < dense.size(); ++v)
      if (dense[v] != T(0.0f)) out.vertices.push_back(v), out.deltas.push_back(dense[v]);
    return out;
  }
};

/// Copies that the importer made of one vertex are written once where they differ in flat normals only, which are not
/// written. The order of the scene stays where `source_vertex` is empty, has gaps, or copies differ in their tangents.
/// cost O(V)
FileVertices file_vertices(const Primitive& primitive);

}  // namespace sinew::write
