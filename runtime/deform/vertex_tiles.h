// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/model/skin.h"

namespace sinew {

/// One number (a coordinate or a weight) for each vertex of a tile, on a cache line of its own.
struct alignas(64) TilePlane {
  std::array<float, 16> lane;
};

/// Vertices that follow the same set of joints. They fill consecutive lanes of consecutive tiles, from the start of a
/// tile.
struct TileRun {
  std::uint32_t first_tile = 0;
  std::uint32_t lane_count = 0;    ///< number of vertices; later lanes of the last tile repeat the last vertex
  std::uint32_t first_weight = 0;  ///< into VertexTiles::weights
  std::uint32_t first_joint = 0;   ///< into VertexTiles::joints
  std::uint32_t joint_count = 0;   ///< each but the last has a plane of weights; the last weighs 1 minus their sum
  std::uint32_t in_fours = 0, in_eights = 0,
                in_sixteens = 0;  ///< number of first lanes that form groups of 4, 8 and 16 consecutive vertices

  std::size_t weights_per_tile() const noexcept { return std::size_t{joint_count} - 1; }
};

/// Vertices of a primitive in the order in which linear skinning is fastest (SkinTilesJob). The order depends on the
/// mesh alone: it is made once, and all characters and instruction sets share it.
///
/// Vertices are sorted by the set of their joints. If the last vertices of a set do not fill a vector, they move to
/// free lanes of larger sets. There, joints that a vertex does not follow have weight 0. The weights of a vertex are
/// divided by their sum. The weight of the lowest joint, which is last in its run, is 1 minus the others and is not
/// stored.
/// Equal vertices give equal bits, even if they belong to two primitives, so that seams stay closed.
struct VertexTiles {
  static constexpr std::uint32_t kLanes = 16;
  static constexpr std::uint32_t kNotInARow = 0x7fffffff;

  std::vector<TileRun> runs;            ///< in order of their number of joints, then of their first vertex
  std::vector<std::uint16_t> joints;    ///< of all runs, one run after the other
  std::vector<TilePlane> positions;     ///< for each tile: x, y, z
  std::vector<TilePlane> weights;       ///< for each tile: a plane for each joint of its run but the last
  std::vector<TilePlane> normals;       ///< for each tile: x, y, z; empty = the mesh has none
  std::vector<TilePlane> tangents;      ///< for each tile: x, y, z, w; empty = the mesh has none
  std::vector<TilePlane> centers;       ///< for each tile: x, y, z of centers of rotation; empty = none were given
  std::vector<std::uint32_t> vertices;  ///< [tiles * kLanes] the vertex of each lane
  std::vector<std::uint32_t> fours;     ///< [tiles * 4] first of four consecutive vertices in four lanes, or kNotInARow
  std::uint32_t vertex_count = 0;
  std::uint32_t joint_count = 0;  ///< 1 + the largest of `joints`

  bool empty() const noexcept { return runs.empty(); }
  std::size_t tile_count() const noexcept { return vertices.size() / kLanes; }
  static constexpr double kMostCost = 1.6;  ///< above this relative_cost(), SkinLinearJob is at least as fast

  /// Estimated time of skinning, relative to the best case of full vectors of consecutive vertices. Measured on AVX2: a
  /// vector of scattered vertices takes 1.8 times as long, and each run adds the time of one vector.
  SINEW_API double relative_cost() const noexcept;
};

/// Vertex attributes in the order of VertexTiles, tile after tile: x, y, z of positions and normals, and x, y, z, w of
/// tangents.
struct TiledInput {
  std::span<const TilePlane> positions, normals, tangents;
};
struct TiledOutput {
  std::span<TilePlane> positions, normals, tangents;
};

/// The attributes that were given to tile_vertices().
inline TiledInput attributes_of(const VertexTiles& tiles) noexcept {
  return {.positions = tiles.positions, .normals = tiles.normals, .tangents = tiles.tangents};
}

/// Sorts vertices into tiles.
/// in   influences  groups cover all vertices, and weights sum to 1;   vertices  at rest
///      centers[V or none]  centers of rotation. A vertex that follows one joint gets itself as its center, which skins
///      it linearly (SkinCenterOfRotationJob).
/// cost O(V log V + influences), allocates 4 (k + 2) bytes a vertex with k joints, 12 more with normals, 16 more with
///      tangents and 12 more with centers
SINEW_API VertexTiles tile_vertices(const VertexInfluences& influences, const VertexInput& vertices,
                                    std::span<const glm::vec3> centers = {});

}  // namespace sinew
