// SPDX-License-Identifier: MIT
// Moves attributes of a tile from memory to lanes and back. Lane i holds vertex `vertex_of_lane(i)` of the tile.
#if defined(SINEW_LANE_MEMORY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANE_MEMORY_INL_H_
#undef SINEW_LANE_MEMORY_INL_H_
#else
#define SINEW_LANE_MEMORY_INL_H_
#endif

#include "runtime/deform/simd/lanes-inl.h"
#include "runtime/deform/simd/quarter_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

/// The scalar target has one lane, so lanes need no reordering.
constexpr std::size_t vertex_of_lane(std::size_t lane) { return lane; }
constexpr std::size_t vertex_of_quarter_lane(std::size_t lane) { return lane; }

HWY_INLINE Lanes3 load3(const glm::vec3* tile) {
  return {hn::LoadU(TileTag(), &tile->x), hn::LoadU(TileTag(), &tile->y), hn::LoadU(TileTag(), &tile->z)};
}
HWY_INLINE void store3(const Lanes3& v, glm::vec3* tile) { hn::StoreInterleaved3(v.x, v.y, v.z, TileTag(), &tile->x); }
HWY_INLINE Lanes4 load4(const glm::vec4* tile) {
  Lanes4 out;
  hn::LoadInterleaved4(TileTag(), &tile->x, out.x, out.y, out.z, out.w);
  return out;
}
HWY_INLINE void store4(const Lanes4& v, glm::vec4* tile) {
  hn::StoreInterleaved4(v.x, v.y, v.z, v.w, TileTag(), &tile->x);
}

#else

/// Transposes four vertices (x y z w) in each 128-bit block to x, y, z and w of four vertices. Also the inverse of
/// itself.
HWY_INLINE Lanes4 transpose(Wide a, Wide b, Wide c, Wide e) { return transpose_blocks(TileTag(), a, b, c, e); }

#if HWY_MAX_BYTES >= 64

// With 512 bits, lanes are in the order of transposed quarters: moving blocks would cost more than it saves.
constexpr std::size_t vertex_of_lane(std::size_t lane) { return vertex_of_quarter_lane(lane); }

HWY_INLINE Lanes4 lanes_of_quarters(Wide a, Wide b, Wide c, Wide e) { return transpose(a, b, c, e); }

HWY_INLINE Lanes3 load3(const glm::vec3* tile) {
  const Lanes4 all =
      transpose(load_quarter<0>(tile), load_quarter<1>(tile), load_quarter<2>(tile), load_quarter<3>(tile));
  return {all.x, all.y, all.z};
}

HWY_INLINE void store3(const Lanes3& v, glm::vec3* tile) {
  const Lanes4 all = transpose(v.x, v.y, v.z, v.z);
  const Wide quarters[4] = {all.x, all.y, all.z, all.w};
  store_packed(quarters, tile);
}

HWY_INLINE Lanes4 load4(const glm::vec4* tile) {
  const auto quarter = [&](std::size_t q) HWY_ATTR { return hn::LoadU(TileTag(), &tile[q * kBlocks].x); };
  return transpose(quarter(0), quarter(1), quarter(2), quarter(3));
}

HWY_INLINE void store4(const Lanes4& v, glm::vec4* tile) {
  const Lanes4 all = transpose(v.x, v.y, v.z, v.w);
  const auto store = [&](Wide quarter, std::size_t q)
                         HWY_ATTR { hn::StoreU(quarter, TileTag(), &tile[q * kBlocks].x); };
  store(all.x, 0);
  store(all.y, 1);
  store(all.z, 2);
  store(all.w, 3);
}

#else

constexpr std::size_t vertex_of_lane(std::size_t lane) { return lane; }

HWY_INLINE Lanes4 lanes_of_quarters(Wide a, Wide b, Wide c, Wide e) {
#if HWY_MAX_BYTES >= 32
  const TileTag d;
  return transpose(hn::ConcatLowerLower(d, c, a), hn::ConcatUpperUpper(d, c, a), hn::ConcatLowerLower(d, e, b),
                   hn::ConcatUpperUpper(d, e, b));
#else
  return transpose(a, b, c, e);
#endif
}

HWY_INLINE Lanes3 load3(const glm::vec3* tile) {
  Lanes3 out;
  hn::LoadInterleaved3(TileTag(), &tile->x, out.x, out.y, out.z);
  return out;
}

/// The twelve floats of a block's vertices are x0 y0 z0 x1, y1 z1 x2 y2, z2 x3 y3 z3. This takes two instructions fewer
/// than Highway's StoreInterleaved3.
HWY_INLINE void store3(const Lanes3& v, glm::vec3* tile) {
  const TileTag d;
  const hn::RepartitionToWide<TileTag> pairs;
  const auto wide = [&](Wide a) HWY_ATTR { return hn::BitCast(pairs, a); };
  const Wide zx = hn::OddEven(v.x, v.z);  // z0 x1 z2 x3
  const Wide a = hn::BitCast(d, hn::InterleaveLower(pairs, wide(hn::InterleaveLower(d, v.x, v.y)), wide(zx)));
  const Wide b = hn::CombineShiftRightBytes<8>(d, hn::InterleaveUpper(d, v.x, v.y), hn::InterleaveLower(d, v.y, v.z));
  const Wide c = hn::BitCast(d, hn::InterleaveUpper(pairs, wide(zx), wide(hn::InterleaveUpper(d, v.y, v.z))));
  float* to = &tile->x;
#if HWY_MAX_BYTES >= 32
  hn::StoreU(hn::ConcatLowerLower(d, b, a), d, to);
  hn::StoreU(hn::ConcatUpperLower(d, a, c), d, to + kTileSize);
  hn::StoreU(hn::ConcatUpperUpper(d, c, b), d, to + 2 * kTileSize);
#else
  hn::StoreU(a, d, to);
  hn::StoreU(b, d, to + kTileSize);
  hn::StoreU(c, d, to + 2 * kTileSize);
#endif
}

HWY_INLINE Lanes4 load4(const glm::vec4* tile) {
  Lanes4 out;
  hn::LoadInterleaved4(TileTag(), &tile->x, out.x, out.y, out.z, out.w);
  return out;
}
HWY_INLINE void store4(const Lanes4& v, glm::vec4* tile) {
  hn::StoreInterleaved4(v.x, v.y, v.z, v.w, TileTag(), &tile->x);
}

#endif  // HWY_MAX_BYTES

#endif  // HWY_TARGET

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
