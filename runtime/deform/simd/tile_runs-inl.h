// SPDX-License-Identifier: MIT
// Loops over the lanes of a run (vertex_tiles.h) for every kind of skinning.
#if defined(SINEW_TILE_RUNS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TILE_RUNS_INL_H_
#undef SINEW_TILE_RUNS_INL_H_
#else
#define SINEW_TILE_RUNS_INL_H_
#endif

#include "runtime/deform/simd/non_temporal_stores-inl.h"
#include "runtime/deform/simd/tile_planes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// A job's tiles, and the attributes that it reads and writes.
struct TileStreams {
  const VertexTiles& tiles;
  TiledInput in;
  VertexOutput out;
  bool past_caches;  ///< stores may bypass the caches where they are aligned

  bool is_aligned(std::size_t vertex) const {
    const auto address = [](const void* at) { return reinterpret_cast<std::uintptr_t>(at); };
    return (address(out.positions.data() + vertex) | (out.normals.empty() ? 0 : address(out.normals.data() + vertex)) |
            (out.tangents.empty() ? 0 : address(out.tangents.data() + vertex))) %
               sizeof(Wide) ==
           0;
  }
  const std::uint16_t* joints_of(const TileRun& run) const { return tiles.joints.data() + run.first_joint; }
  /// The vertex of each lane of a run.
  const std::uint32_t* vertices_of(const TileRun& run) const {
    return &tiles.vertices[std::size_t{run.first_tile} * VertexTiles::kLanes];
  }
};

/// True if a job's stores may bypass the caches. With four lanes arithmetic, not memory, limits the speed.
inline bool wants_streams(const VertexTiles& tiles, AttributesPresent wanted, bool asked) {
  const std::size_t bytes = sizeof(glm::vec3) * (1 + wanted.normals) + sizeof(glm::vec4) * wanted.tangents;
  return kTileSize > 1 && ((asked && kTileSize >= 8) || tiles.vertex_count * bytes >= kStreamedBytes);
}

/// Pointers to the planes of a tile.
struct TileInputs {
  const TilePlane* positions;
  const TilePlane* weights;
  const TilePlane* normals;
  const TilePlane* tangents;
  const TilePlane* centers;  ///< set for kinds of skinning that read them (kCenters)
};

/// Places for one vector of skinned vertices.
struct LaneOutputs {
  glm::vec3* positions;
  glm::vec3* normals;
  glm::vec4* tangents;
};

/// A buffer for one vector of skinned vertices. They are then copied to scattered places, or stored past the caches.
struct KeptVertices {
  HWY_ALIGN glm::vec3 positions[kTileSize];
  HWY_ALIGN glm::vec3 normals[kTileSize];
  HWY_ALIGN glm::vec4 tangents[kTileSize];

  HWY_NOINLINE void store(const TileStreams& s, const LaneVertices& at, AttributesPresent has) const {
    scatter(positions, at, s.past_caches, s.out.positions.data());
    if (has.normals) scatter(normals, at, s.past_caches, s.out.normals.data());
    if (has.tangents) scatter(tangents, at, s.past_caches, s.out.tangents.data());
  }
};

/// Skins the vertices of a run.
/// in   Lanes  a kind of skinning, made once a run from `joints`: the matrices or motions that its vertices follow.
///      kCount    its number of joints at compile time; 0 = known at run time only
///      kCenters  true: it reads centers of rotation
///      wanted()  the attributes that it skins
///      skin(lane, tile, out)  skins one vector; returns what mend() needs
///      mend(result, run, lane_of_run, tile)  computes the lanes again that lost digits
template <class Lanes, class Joints>
HWY_NOINLINE void skin_run(const TileStreams& s, const TileRun& run, const Joints& joints) {
  const Lanes lanes(joints, s, run);
  const AttributesPresent wanted = lanes.wanted();
  const std::size_t weights = Lanes::kCount > 0 ? static_cast<std::size_t>(Lanes::kCount) - 1 : run.weights_per_tile();
  const std::size_t lane_count = run.lane_count, row_lanes = lanes_in_a_row(run);
  const std::uint32_t* vertices = s.vertices_of(run);
  const std::size_t direct_lanes = s.past_caches && s.is_aligned(*vertices) ? 0 : row_lanes;
  const std::uint32_t* fours = &s.tiles.fours[std::size_t{run.first_tile} * VertexTiles::kLanes / 4];
  const VertexOutput out = s.out;  // a copy, which no store can change
  TileInputs tile{s.in.positions.data() + std::size_t{run.first_tile} * 3, s.tiles.weights.data() + run.first_weight,
                  wanted.normals ? s.in.normals.data() + std::size_t{run.first_tile} * 3 : nullptr,
                  wanted.tangents ? s.in.tangents.data() + std::size_t{run.first_tile} * 4 : nullptr,
                  Lanes::kCenters ? s.tiles.centers.data() + std::size_t{run.first_tile} * 3 : nullptr};
  KeptVertices kept;
  for (std::size_t lane = 0, in_tile = 0; lane < lane_count; lane += kTileSize) {
    LaneOutputs to{kept.positions, kept.normals, kept.tangents};
    const bool is_direct = lane < direct_lanes;
    if (HWY_LIKELY(is_direct)) {
      const std::size_t first = kTileSize == 1 ? vertices[lane] : fours[lane / 4];
      to.positions = out.positions.data() + first;
      if (wanted.normals) to.normals = out.normals.data() + first;
      if (wanted.tangents) to.tangents = out.tangents.data() + first;
    }
    const auto result = lanes.skin(in_tile, tile, to);
    if (HWY_UNLIKELY(!is_direct))
      kept.store(s, {vertices + lane, fours + lane / 4, lane_count - lane, lane < row_lanes}, wanted);
    lanes.mend(result, run, lane, tile);
    in_tile += kTileSize;
    if (in_tile < VertexTiles::kLanes) continue;
    in_tile = 0;
    tile.positions += 3;
    tile.weights += weights;
    if (wanted.normals) tile.normals += 3;
    if (wanted.tangents) tile.tangents += 4;
    if constexpr (Lanes::kCenters) tile.centers += 3;
  }
}

/// Calls `body` with the number of joints as a std::integral_constant; 0 stands for five joints and more.
template <class Body>
void with_joint_count(const TileRun& run, const Body& body) {
  switch (run.joint_count) {
    case 1: body(std::integral_constant<int, 1>()); break;
    case 2: body(std::integral_constant<int, 2>()); break;
    case 3: body(std::integral_constant<int, 3>()); break;
    case 4: body(std::integral_constant<int, 4>()); break;
    default: body(std::integral_constant<int, 0>()); break;
  }
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
