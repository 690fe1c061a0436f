// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/deform/vertex_tiles.h"
#include "runtime/model/morph_set.h"

namespace sinew {

/// Displacements of one attribute by a morph target, in the order of VertexTiles: every tile of which a vertex moves,
/// as a whole.
struct TiledDeltas {
  std::vector<std::uint32_t> tiles;  ///< increasing
  std::vector<TilePlane> planes;     ///< for each of `tiles`: x, y, z; 0 where a vertex does not move
};

struct TiledTarget {
  TiledDeltas positions, normals, tangents;
};

/// The morph targets of a primitive in the order of its tiles (MorphTilesJob).
struct TiledMorphs {
  static constexpr double kMostMemory = 3.0;  ///< above this relative_memory, tiles waste more than they gain

  std::vector<TiledTarget> targets;
  double relative_memory = 0;  ///< bytes of all planes, relative to those of the deltas of the MorphSet; 0 = no deltas
};

/// Sorts displacements into tiles. Attributes that the tiles do not have are left out.
/// in   morphs  of the primitive of the tiles
/// cost O(V + deltas log deltas)
SINEW_API TiledMorphs tile_morphs(const MorphSet& morphs, const VertexTiles& tiles);

}  // namespace sinew
