// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sinew {

/// The triangles of a mesh with flat faces, sorted by how their vertices lie in memory. The triangle of the last vertex
/// ends its list: code that reads four floats from the vertices of all triangles before it stays inside the array.
struct FlatFaces {
  std::vector<std::uint32_t> runs;      ///< first vertices of the triangles of three vertices in a row
  std::vector<std::uint32_t> corners;   ///< [3 each] of the other triangles
  std::vector<std::uint32_t> faceless;  ///< vertices of no triangle
  bool share_vertices = false;  ///< some vertex has several triangles; `corners` has all of them in the mesh's order

  std::size_t count() const noexcept { return runs.size() + corners.size() / 3; }
};

/// in   triangles[3T]  below `vertex_count`
/// cost O(V + T), allocates
FlatFaces sort_flat_faces(std::span<const std::uint32_t> triangles, std::size_t vertex_count);

}  // namespace sinew
