// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/api.h"

namespace sinew {

/// A run of triangles whose corners lie in three runs of consecutive vertices: triangle t has the vertices first[c] + t
/// for c = 0, 1, 2. SIMD code then loads corners without gathering.
struct FlatStream {
  static constexpr std::uint32_t kFewest = 16;  ///< fewest triangles of a stream: fills the widest vectors

  std::array<std::uint32_t, 3> first{};
  std::uint32_t count = 0;
};

/// The triangles of a flat-shaded mesh, sorted by how their vertices lie in memory. The importer orders vertices so
/// that nearly all triangles are in streams (importer/topology/flat_order.h).
struct FlatFaces {
  std::vector<FlatStream> streams;
  /// [3 per triangle] Triangles outside of streams. Some are listed twice to fill the widest vectors. None uses the
  /// last vertex of the mesh, because SIMD code may read four floats from each vertex.
  std::vector<std::uint32_t> corners;
  /// [3 per triangle] Triangles that are computed one by one. If no vertex belongs to several triangles, this is at
  /// most the triangle of the last vertex. Otherwise it is all triangles in the mesh's order.
  std::vector<std::uint32_t> alone;
  /// Vertices whose normals are set to the rest normals before triangles are computed: vertices of `alone`, and
  /// vertices of no triangle.
  std::vector<std::uint32_t> at_rest;
  std::size_t count = 0;  ///< number of triangles
};

/// in   triangles[3T]  each below `vertex_count`
/// cost O(V + T log T), allocates
SINEW_API FlatFaces sort_flat_faces(std::span<const std::uint32_t> triangles, std::size_t vertex_count);

}  // namespace sinew
