// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// Which triangles meet along edges, taken from a half-edge mesh (OpenMesh). The input need not be manifold: an edge
/// with more than two faces, or with two faces of opposite winding, is cut open, and a vertex whose faces do not form
/// one fan is duplicated. `source` maps back to the caller's vertices.
struct Adjacency {
  /// [3F] the half-edge vertex of each corner; kNone in faces with fewer than three different corners
  std::vector<std::uint32_t> corner_vertex;
  std::vector<std::uint32_t> source;     ///< [M] the caller's vertex that each half-edge vertex stands for
  std::vector<std::uint32_t> neighbour;  ///< [3F] the face across the edge from corner c to the next corner, or kNone

  std::size_t face_count() const noexcept { return corner_vertex.size() / 3; }
};

/// The next corner of the same face.
constexpr std::size_t next_corner(std::size_t c) noexcept { return c % 3 == 2 ? c - 2 : c + 1; }

/// in    triangles[3F]   vertex indices below vertex_count; a face that names a vertex twice is left out
/// cost  O(F) expected
Adjacency make_adjacency(std::span<const std::uint32_t> triangles, std::size_t vertex_count);

}  // namespace sinew
