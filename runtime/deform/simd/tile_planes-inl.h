// SPDX-License-Identifier: MIT
// Moves attributes between planes of tiles, lanes and arrays of vertices. Lanes keep the order of the tile.
#if defined(SINEW_TILE_PLANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TILE_PLANES_INL_H_
#undef SINEW_TILE_PLANES_INL_H_
#else
#define SINEW_TILE_PLANES_INL_H_
#endif

#include <hwy/cache_control.h>

#include <cstdint>
#include <cstring>

#include "runtime/deform/simd/lane_memory-inl.h"
#include "runtime/deform/simd/triples-inl.h"
#include "runtime/deform/vertex_tiles.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Lanes from the front of a run that are vectors of vertices in a row.
HWY_INLINE std::size_t lanes_in_a_row(const TileRun& run) {
  return kTileSize == 1   ? run.lane_count
         : kTileSize == 4 ? run.in_fours
         : kTileSize == 8 ? run.in_eights
                          : run.in_sixteens;
}

HWY_INLINE Wide load_plane(const TilePlane& plane, std::size_t lane) {
  return hn::Load(TileTag(), plane.lane.data() + lane);
}
HWY_INLINE Lanes3 load_planes3(const TilePlane* planes, std::size_t lane) {
  return {load_plane(planes[0], lane), load_plane(planes[1], lane), load_plane(planes[2], lane)};
}

/// Packs lanes to vec3.
HWY_INLINE void pack(const Lanes3& v, glm::vec3* to) {
#if HWY_TARGET != HWY_SCALAR && HWY_MAX_BYTES >= 64
  // Each lane position of the three vectors has one x, one y and one z (triples-inl.h).
  struct Table {
    HWY_ALIGN std::int32_t of[kTileSize];
    explicit constexpr Table(std::size_t component) : of() {
      for (std::size_t at = component; at < 3 * kTileSize; at += 3)
        of[at % kTileSize] = static_cast<std::int32_t>(at / 3);
    }
  };
  static constexpr Table kOfX(0), kOfY(1), kOfZ(2);
  const auto placed = [](Wide lanes, const Table& table)
                          HWY_ATTR { return hn::TableLookupLanes(lanes, hn::SetTableIndices(TileTag(), table.of)); };
  const Wide of[3] = {placed(v.x, kOfX), placed(v.y, kOfY), placed(v.z, kOfZ)};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t first = i * kTileSize;
    hn::StoreU(blend3(of[first % 3], of[(first + 1) % 3], of[(first + 2) % 3]), TileTag(), &to->x + first);
  }
#else
  store3(v, to);
#endif
}
HWY_INLINE void pack(const Lanes4& v, glm::vec4* to) { hn::StoreInterleaved4(v.x, v.y, v.z, v.w, TileTag(), &to->x); }

/// Writes the attributes of a vector's vertices to their lanes of planes.
template <class V>
void gather(const V* all, const std::uint32_t* vertices, std::size_t lane, TilePlane* planes) {
  for (std::size_t i = 0; i < kTileSize; ++i)
    for (int c = 0; c < V::length(); ++c) planes[c].lane[lane + i] = all[vertices[i]][c];
}

/// Copies packed attributes to where the vertices lie.
/// in   streams  the vertices are in a row: bypass the caches if the place is aligned to vectors
template <class V>
void scatter(const V* packed, const std::uint32_t* vertices, const std::uint32_t* fours, bool streams, V* all) {
  V* to = all + *vertices;
  if (streams && reinterpret_cast<std::uintptr_t>(to) % sizeof(Wide) == 0) {
    const TileTag d;
    for (std::size_t i = 0; i < static_cast<std::size_t>(V::length()) * kTileSize; i += kTileSize)
      hn::Stream(hn::LoadU(d, &packed->x + i), d, &to->x + i);
    return;
  }
  if constexpr (kTileSize == 1) {
    *to = *packed;
  } else {
    for (std::size_t i = 0; i < kTileSize; i += 4)
      if (fours[i / 4] != VertexTiles::kNotInARow)
        std::memcpy(all + fours[i / 4], packed + i, 4 * sizeof(V));
      else
        for (std::size_t k = i; k < i + 4; ++k) all[vertices[k]] = packed[k];
  }
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
