// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// Triangle adjacency, from a half-edge mesh (OpenMesh). The input may be non-manifold. Edges with more than two faces,
/// or with two faces of opposite winding, are cut open. Vertices whose faces do not form one fan are duplicated.
/// `source` maps back to the caller's vertices.
struct Adjacency {
  /// [3F] half-edge vertex of each corner; kNone in degenerate faces
  std::vector<std::uint32_t> corner_vertex;
  std::vector<std::uint32_t> source;     ///< [M] caller's vertex of each half-edge vertex
  std::vector<std::uint32_t> neighbour;  ///< [3F] face across the edge from corner c to the next corner; kNone = border

  std::size_t face_count() const noexcept { return corner_vertex.size() / 3; }
};

/// The next corner of the same face.
constexpr std::size_t next_corner(std::size_t c) noexcept { return c % 3 == 2 ? c - 2 : c + 1; }

/// Computes the adjacency of triangles.
/// in    triangles[3F]   vertex indices below vertex_count; degenerate faces are omitted
/// cost  O(F) expected
Adjacency make_adjacency(std::span<const std::uint32_t> triangles, std::size_t vertex_count);

}  // namespace sinew
