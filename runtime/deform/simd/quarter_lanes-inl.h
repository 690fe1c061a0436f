// SPDX-License-Identifier: MIT
// A tile of vertices as four quarter tiles. Each 128-bit block of a quarter holds one vertex, (x y z -).
#if defined(SINEW_QUARTER_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_QUARTER_LANES_INL_H_
#undef SINEW_QUARTER_LANES_INL_H_
#else
#define SINEW_QUARTER_LANES_INL_H_
#endif

#include <type_traits>

#include "runtime/deform/simd/tile-inl.h"
#include "runtime/pose/simd/transpose-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

constexpr std::size_t kBlocks = kTileSize / 4;  ///< vertices per quarter

/// Components of the vertices of a quarter. Each component fills the 128-bit block of its vertex.
struct Spread3 {
  Wide x, y, z;
};

/// Calls `body(std::integral_constant)` for the four quarters. Unrolled, so that results stay in registers.
template <class Body>
HWY_INLINE void for_each_quarter(const Body& body) {
  body(std::integral_constant<std::size_t, 0>{});
  body(std::integral_constant<std::size_t, 1>{});
  body(std::integral_constant<std::size_t, 2>{});
  body(std::integral_constant<std::size_t, 3>{});
}

/// Lane indices for TableLookupLanes; `lane(i)` gives each.
struct LaneTable {
  HWY_ALIGN std::int32_t lanes[kTileSize];
  template <class Lane>
  constexpr explicit LaneTable(const Lane& lane) : lanes() {
    for (std::size_t i = 0; i < kTileSize; ++i) lanes[i] = static_cast<std::int32_t>(lane(i));
  }
};

HWY_INLINE Spread3 spread(Wide quarter) {
  return {broadcast<0>(quarter), broadcast<1>(quarter), broadcast<2>(quarter)};
}

/// Loads one quarter of a tile of packed vec3. The last quarter reads exactly to the end of the tile.
template <std::size_t kQuarter>
HWY_INLINE Wide load_quarter(const glm::vec3* tile) {
  constexpr std::size_t kBefore = kQuarter == 3 ? kBlocks : 0;
  const Wide packed = hn::LoadU(TileTag(), &tile->x + kQuarter * 3 * kBlocks - kBefore);
  static constexpr LaneTable kTable([](std::size_t i) { return kBefore + i / 4 * 3 + i % 4 % 3; });
  return hn::TableLookupLanes(packed, hn::SetTableIndices(TileTag(), kTable.lanes));
}

/// Loads a quarter and spreads its components. Four lanes need no shuffle across 128-bit blocks.
template <std::size_t kQuarter>
HWY_INLINE Spread3 load_spread(const glm::vec3* tile) {
  if constexpr (kTileSize > 4) return spread(load_quarter<kQuarter>(tile));
  constexpr std::size_t kBefore = kQuarter == 3 ? 1 : 0;
  const Wide packed = hn::LoadU(TileTag(), &tile->x + kQuarter * 3 - kBefore);
  return {broadcast<kBefore>(packed), broadcast<kBefore + 1>(packed), broadcast<kBefore + 2>(packed)};
}

/// Moves the lanes of a quarter to their places in one third of the packed tile. Lanes that belong to another quarter
/// get arbitrary values. Places repeat from quarter to quarter, so both quarters of a third use one table.
template <std::size_t kThird>
HWY_INLINE Wide packed_third(Wide quarter) {
  static constexpr LaneTable kTable([](std::size_t i) {
    const std::size_t of_quarter = (kThird * kTileSize + i) % (3 * kBlocks);
    return of_quarter / 3 * 4 + of_quarter % 3;
  });
  return hn::TableLookupLanes(quarter, hn::SetTableIndices(TileTag(), kTable.lanes));
}

struct PackedTile {
  Wide thirds[3];
};

HWY_INLINE PackedTile packed(const Wide (&quarter)[4]) {
  const TileTag d;
#if HWY_MAX_BYTES >= 32
  return {hn::IfThenElse(hn::FirstN(d, 3 * kBlocks), packed_third<0>(quarter[0]), packed_third<0>(quarter[1])),
          hn::ConcatUpperLower(d, packed_third<1>(quarter[2]), packed_third<1>(quarter[1])),
          hn::IfThenElse(hn::FirstN(d, kBlocks), packed_third<2>(quarter[2]), packed_third<2>(quarter[3]))};
#else
  // (x y z -) becomes (- x y z) and is joined with the next vertex. With four lanes this takes fewer steps than tables
  // and masks.
  const Wide first = hn::Shuffle2103(quarter[0]), second = hn::Shuffle2103(quarter[1]);
  const Wide third = hn::Shuffle2103(quarter[2]);
  return {hn::CombineShiftRightLanes<1>(d, quarter[1], first), hn::CombineShiftRightLanes<2>(d, quarter[2], second),
          hn::CombineShiftRightLanes<3>(d, quarter[3], third)};
#endif
}

/// Stores a tile of packed vec3. Use `past_caches` (non-temporal stores) only if `out` is aligned to vectors.
HWY_INLINE void store_packed(const Wide (&quarter)[4], glm::vec3* out, bool past_caches = false) {
  const TileTag d;
  float* to = &out->x;
  const PackedTile tile = packed(quarter);
  if (past_caches) {
    hn::Stream(tile.thirds[0], d, to);
    hn::Stream(tile.thirds[1], d, to + kTileSize);
    hn::Stream(tile.thirds[2], d, to + 2 * kTileSize);
  } else {
    hn::StoreU(tile.thirds[0], d, to);
    hn::StoreU(tile.thirds[1], d, to + kTileSize);
    hn::StoreU(tile.thirds[2], d, to + 2 * kTileSize);
  }
}

/// The vertex of the tile that a lane holds after transpose_blocks(): x, y and z of all vertices in one vector each. It
/// transposes the four quarters within each 128-bit block, so no lane crosses blocks.
constexpr std::size_t vertex_of_quarter_lane(std::size_t lane) { return lane % 4 * kBlocks + lane / 4; }

/// Normalises the vectors of a tile, with an exact square root and division. Returns the lanes (vertex_of_quarter_lane)
/// whose squared length lies where float keeps its digits. All other lanes are wrong.
HWY_INLINE hn::Mask<TileTag> normalise(Wide (&quarter)[4]) {
  const TileTag d;
  const FourVectors<Wide> v = transpose_blocks(d, quarter[0], quarter[1], quarter[2], quarter[3]);
  const Wide squared = hn::MulAdd(v.z, v.z, hn::MulAdd(v.y, v.y, hn::Mul(v.x, v.x)));
  const Wide scale = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(squared));
  quarter[0] = hn::Mul(quarter[0], broadcast<0>(scale));
  quarter[1] = hn::Mul(quarter[1], broadcast<1>(scale));
  quarter[2] = hn::Mul(quarter[2], broadcast<2>(scale));
  quarter[3] = hn::Mul(quarter[3], broadcast<3>(scale));
  return keeps_digits(squared);
}

/// The quarters of a tile, kept in memory until they are stored.
struct KeptQuarters {
  HWY_ALIGN float lanes[4][kTileSize];

  HWY_INLINE void keep(std::size_t q, Wide quarter) { hn::Store(quarter, TileTag(), lanes[q]); }
  HWY_INLINE void load(Wide (&quarter)[4]) const {
    for_each_quarter([&](auto q) HWY_ATTR { quarter[q] = hn::Load(TileTag(), lanes[q]); });
  }
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
