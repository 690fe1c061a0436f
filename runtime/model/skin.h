// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// The joints that deform a mesh. Joint indices of vertices are indices into `joints`, not joints of the skeleton
/// (G36).
/// eq   palette[i] = world(joints[i]) * inverse_bind[i]   (glTF 2.0, "Skins"; the transform of the mesh's node is
///      ignored, G29)
struct Skin {
  std::string name;
  std::vector<std::uint32_t> joints;    ///< [N] skeleton joints, in any order
  std::vector<Affine> inverse_bind;     ///< [N] inverse bind matrices; identity where the file has none (G31)
  std::uint32_t skeleton_root = kNone;  ///< a hint of the file that no job reads (G30)
};

/// A run of vertices with the same number of influences.
struct InfluenceGroup {
  std::uint32_t first_vertex = 0;
  std::uint32_t vertex_count = 0;
  std::uint32_t influence_count = 0;  ///< exact count per vertex, >= 1
  std::uint32_t first_influence = 0;  ///< into joints / weights of VertexInfluences
};

/// Which joints move each vertex of a primitive, and how much. Vertices are grouped by influence count; the groups
/// cover all vertices and all influences in order. Within a vertex weights fall and sum to 1, so that the first joint
/// is the heaviest; equal weights are by rising joint. The importer removes zero weights and adds up repeated joints
/// (G38, G39, G41).
struct VertexInfluences {
  std::vector<InfluenceGroup> groups;
  std::vector<std::uint16_t> joints;  ///< index into Skin::joints, influence_count per vertex, vertex after vertex
  std::vector<float> weights;         ///< parallel to `joints`

  bool empty() const noexcept { return groups.empty(); }
};

}  // namespace sinew
