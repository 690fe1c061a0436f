// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sinew {

/// Triangles whose corners are three streams of vertices: triangle t has the vertices first[c] + t, c = 0, 1, 2.
struct FlatStream {
  static constexpr std::uint32_t kFewest = 16;  ///< triangles, so that the widest vectors are full

  std::array<std::uint32_t, 3> first{};
  std::uint32_t count = 0;
};

/// The triangles of a mesh with flat faces, sorted by how their vertices lie in memory. The importer orders vertices so
/// that nearly all triangles are in streams (importer/topology/flat_order.h).
struct FlatFaces {
  std::vector<FlatStream> streams;
  /// [3 each] of the other triangles, some twice, so that they fill the widest vectors. Without the last vertex of the
  /// mesh: code may read four floats from each vertex.
  std::vector<std::uint32_t> corners;
  /// [3 each] of triangles that are done one after another: that of the last vertex, when it is in no stream; all, in
  /// the mesh's order, when some vertex has several.
  std::vector<std::uint32_t> alone;
  std::vector<std::uint32_t> at_rest;  ///< vertices that start with the normals of rest: of `alone`, and of no triangle
  std::size_t count = 0;               ///< of triangles
};

/// in   triangles[3T]  below `vertex_count`
/// cost O(V + T log T), allocates
FlatFaces sort_flat_faces(std::span<const std::uint32_t> triangles, std::size_t vertex_count);

}  // namespace sinew
