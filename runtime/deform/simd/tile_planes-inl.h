// SPDX-License-Identifier: MIT
// Moves attributes between planes of tiles (TilePlane), lanes and arrays of vertices. Lane i holds vertex i of the
// vector.
#if defined(SINEW_TILE_PLANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TILE_PLANES_INL_H_
#undef SINEW_TILE_PLANES_INL_H_
#else
#define SINEW_TILE_PLANES_INL_H_
#endif

#include <hwy/cache_control.h>

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "runtime/deform/simd/lane_memory-inl.h"
#include "runtime/deform/simd/triples-inl.h"
#include "runtime/deform/vertex_tiles.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Number of lanes at the front of a run that form vectors of consecutive vertices.
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

/// Writes lanes as packed vec3.
HWY_INLINE void pack(const Lanes3& v, glm::vec3* to) {
#if HWY_TARGET != HWY_SCALAR && HWY_MAX_BYTES >= 64
  // At each lane position, the three vectors in memory have one x, one y and one z (triples-inl.h).
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

/// The mesh vertices that one vector of lanes holds.
struct LaneVertices {
  const std::uint32_t* vertices;  ///< [kTileSize] vertex of each lane
  const std::uint32_t* fours;     ///< [kTileSize / 4] as VertexTiles::fours
  std::size_t count;              ///< lanes left in the run, which may exceed kTileSize; lanes from here on are padding
  bool in_a_row;
};

#if HWY_TARGET == HWY_SCALAR

template <class V>
void scatter(const V* packed, const LaneVertices& at, bool, V* all) {
  all[*at.vertices] = *packed;
}

#else

/// Copies the vertices of four lanes. Each load lies within one of the vector stores that wrote `packed`. A load that
/// spans two stores is not forwarded from the store buffer and stalls.
template <std::size_t kFirst, std::size_t... kLanes, class V>
HWY_INLINE void copy_four(const V* packed, const std::uint32_t* vertices, V* all, std::index_sequence<kLanes...>) {
  const auto copy = [&](auto lane) {
    constexpr std::size_t kAt = decltype(lane)::value * sizeof(V) % sizeof(Wide);
    constexpr std::size_t kPart = sizeof(Wide) - kAt == sizeof(float) ? sizeof(float) : 2 * sizeof(float);
    const char* from = reinterpret_cast<const char*>(packed + lane);
    char* to = reinterpret_cast<char*>(all + vertices[lane]);
    std::memcpy(to, from, kPart);
    std::memcpy(to + kPart, from + kPart, sizeof(V) - kPart);
  };
  (copy(std::integral_constant<std::size_t, kFirst + kLanes>()), ...);
}

/// Copies four consecutive vertices.
template <class V>
HWY_INLINE void copy_row(const V* packed, V* to) {
  const hn::CappedTag<float, 4> d;
  for (std::size_t i = 0; i < 4 * static_cast<std::size_t>(V::length()); i += 4)
    hn::StoreU(hn::Load(d, &packed->x + i), d, &to->x + i);
}

/// Copies packed attributes to the places of their vertices.
/// in   past_caches  true: consecutive vertices that are aligned to vectors bypass the caches
template <class V>
void scatter(const V* packed, const LaneVertices& at, bool past_caches, V* all) {
  const TileTag d;
  V* to = all + *at.vertices;
  if (past_caches && at.in_a_row && reinterpret_cast<std::uintptr_t>(to) % sizeof(Wide) == 0) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(V::length()) * kTileSize; i += kTileSize)
      hn::Stream(hn::LoadU(d, &packed->x + i), d, &to->x + i);
    return;
  }
  const auto store_four = [&](auto first) {
    if (first >= at.count) return;
    const std::uint32_t four = at.fours[first / 4];
    if (four != VertexTiles::kNotInARow)
      copy_row(packed + first, all + four);
    else
      copy_four<first>(packed, at.vertices, all, std::make_index_sequence<4>());
  };
  store_four(std::integral_constant<std::size_t, 0>());
  if constexpr (kTileSize >= 8) store_four(std::integral_constant<std::size_t, 4>());
  if constexpr (kTileSize >= 16) store_four(std::integral_constant<std::size_t, 8>());
  if constexpr (kTileSize >= 16) store_four(std::integral_constant<std::size_t, 12>());
}

#endif

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
