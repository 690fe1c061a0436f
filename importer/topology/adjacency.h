// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// Which triangles meet along edges, taken from a half-edge mesh (OpenMesh). Input need not be manifold: where an edge
/// has more than two faces, or faces that wind against each other, it is cut open; where the faces of a vertex do not
/// form one fan, the vertex is duplicated. `source` leads back.
struct Adjacency {
  std::vector<std::uint32_t>
      corner_vertex;                     ///< [3F] half-edge vertex of each corner; kNone in faces without three corners
  std::vector<std::uint32_t> source;     ///< [M] the caller's vertex of each half-edge vertex
  std::vector<std::uint32_t> neighbour;  ///< [3F] face across the edge from corner c to the next of its face, or kNone

  std::size_t face_count() const noexcept { return corner_vertex.size() / 3; }
};

/// in   triangles[3F]  vertex indices < vertex_count; repeated indices within a face leave it out
/// cost O(F) expected
Adjacency make_adjacency(std::span<const std::uint32_t> triangles, std::size_t vertex_count);

}  // namespace sinew
