// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// The joints that deform a mesh. Vertices refer to joints by their index in `joints`, not in the skeleton.
/// eq   palette[i] = world(joints[i]) * inverse_bind[i]   (glTF 2.0, "Skins"; the transform of the mesh's node is
///      ignored)
struct Skin {
  std::string name;
  std::vector<std::uint32_t> joints;    ///< [N] joints of the skeleton, in any order
  std::vector<Affine> inverse_bind;     ///< [N] inverse bind matrices; identity where the file has none
  std::uint32_t skeleton_root = kNone;  ///< hint of the file; no job reads it
};

/// Consecutive vertices with the same number of influences.
struct InfluenceGroup {
  std::uint32_t first_vertex = 0;
  std::uint32_t vertex_count = 0;
  std::uint32_t influence_count = 0;  ///< exact count per vertex, >= 1
  std::uint32_t first_influence = 0;  ///< index of the group's first influence in VertexInfluences::joints and weights
};

/// The joints and weights of each vertex of a primitive. Vertices are grouped by influence count; the groups cover all
/// vertices and all influences in order. The weights of a vertex sum to 1 and are sorted in descending order; equal
/// weights are sorted by joint. The importer removes zero weights and merges repeated joints.
struct VertexInfluences {
  std::vector<InfluenceGroup> groups;
  std::vector<std::uint16_t> joints;  ///< index into Skin::joints, influence_count per vertex, vertex after vertex
  std::vector<float> weights;         ///< parallel to `joints`

  bool empty() const noexcept { return groups.empty(); }
};

}  // namespace sinew
