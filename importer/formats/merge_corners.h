// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include <assimp/mesh.h>

namespace sinew::formats {

/// The vertices of a mesh after equal corners are merged. assimp gives each corner of each face a vertex of its own.
struct MergedCorners {
  std::vector<unsigned> corner;                 ///< [V] the first corner of each vertex
  std::vector<std::uint32_t> vertex_of_corner;  ///< [corners]
};

/// Merges corners that agree bit for bit in everything that is imported: also in influences and in every morph target.
/// cost  O(corners), holds a copy of all their numbers
MergedCorners merge_corners(const aiMesh& mesh);

}  // namespace sinew::formats
