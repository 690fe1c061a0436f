// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/model/skin.h"

namespace sinew {

/// One number for each vertex of a tile, on a cache line of its own.
struct alignas(64) TilePlane {
  std::array<float, 16> lane;
};

/// Vertices that follow the same joints. Their lanes lie one behind the other and begin with a tile.
struct TileRun {
  std::uint32_t first_tile = 0;
  std::uint32_t lane_count = 0;   ///< of vertices; later lanes of the last tile repeat the last vertex
  std::uint32_t first_plane = 0;  ///< into VertexTiles::positions
  std::uint32_t first_joint = 0;  ///< into VertexTiles::joints
  std::uint32_t joint_count = 0;  ///< all but the last have planes of weights; the last one has what is left of 1
  std::uint32_t in_fours = 0, in_eights = 0,
                in_sixteens = 0;  ///< lanes from the first on that are fours, eights and sixteens of vertices in a row

  std::size_t planes_per_tile() const noexcept { return std::size_t{2} + joint_count; }
};

/// Vertices of a primitive in the order in which linear skinning is fastest (SkinTilesJob). The order depends on the
/// mesh alone: it is made once, and all characters and instruction sets share it.
///
/// Vertices are sorted by the set of their joints, whose order does not matter. If the last ones of a set
/// fill no vector, they take free lanes of larger sets, with weight 0 for all other joints. The weights of a vertex
/// are divided by their sum. Then the weight of its first joint is 1 minus the others, and is not stored.
/// Vertices that are equal have equal bits afterwards, also those of two primitives: seams stay closed.
struct VertexTiles {
  static constexpr std::uint32_t kLanes = 16;
  static constexpr std::uint32_t kNotInARow = 0x7fffffff;

  std::vector<TileRun> runs;            ///< in order of their number of joints, then of their first vertex
  std::vector<std::uint16_t> joints;    ///< of the runs
  std::vector<TilePlane> positions;     ///< x, y, z and weights of a tile, tile after tile
  std::vector<TilePlane> normals;       ///< x, y, z of a tile; empty = the mesh has none
  std::vector<TilePlane> tangents;      ///< x, y, z, w of a tile; empty = the mesh has none
  std::vector<std::uint32_t> vertices;  ///< [tiles * kLanes] the vertex of each lane
  std::vector<std::uint32_t> fours;     ///< [tiles * 4] the first of four vertices in a row, or kNotInARow
  std::uint32_t vertex_count = 0;
  std::uint32_t joint_count = 0;  ///< 1 + the largest of `joints`

  bool empty() const noexcept { return runs.empty(); }
  std::size_t tile_count() const noexcept { return vertices.size() / kLanes; }
  static constexpr double kMostCost = 1.6;  ///< with a larger relative_cost(), SkinLinearJob is as fast or faster

  /// Estimated time of skinning, relative to the best case: full vectors of consecutive vertices. Measured on AVX2: a
  /// vector of scattered vertices takes 1.8 times as long, and each run takes the time of one more vector.
  SINEW_API double relative_cost() const noexcept;
};

/// Sorts vertices into tiles.
/// in   influences  groups cover all vertices; their weights sum to 1;   vertices  at rest
/// cost O(V log V + influences), allocates 4 (k + 2) bytes a vertex, 12 more with normals and 16 with tangents
SINEW_API VertexTiles tile_vertices(const VertexInfluences& influences, const VertexInput& vertices);

}  // namespace sinew
