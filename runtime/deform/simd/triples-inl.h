// SPDX-License-Identifier: MIT
// Moves packed vec3 of a tile to lanes and back in eight steps each way, if the order of the lanes does not matter.
//
// A tile of N packed vec3 is three vectors of N floats. N is no multiple of 3, so each lane position has one x, one y
// and one z in the three vectors. Two blends collect all x, two all y, two all z. The y and z of a vertex are then one
// and two lanes after its x; two rotations correct that.
#if defined(SINEW_TRIPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TRIPLES_INL_H_
#undef SINEW_TRIPLES_INL_H_
#else
#define SINEW_TRIPLES_INL_H_
#endif

#include <hwy/cache_control.h>

#include <utility>

#include "runtime/deform/simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// A tile of packed vec3 as it lies in memory.
struct Triples {
  Wide thirds[3];
};

/// Vertex that a lane holds in the order of lanes_of(). The x of this vertex is float number `lane` of one of the
/// thirds.
constexpr std::size_t vertex_of_triple_lane(std::size_t lane) {
  std::size_t at = lane;
  while (at % 3 != 0) at += kTileSize;
  return at / 3;
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Lanes3 lanes_of(const Triples& t) { return {t.thirds[0], t.thirds[1], t.thirds[2]}; }
HWY_INLINE Triples triples_of(const Lanes3& v) { return {{v.x, v.y, v.z}}; }

#else

// blend3() takes lane i from vector number i % 3. On Intel a blend by a constant is one instruction, by a mask up to
// three. Highway's emulated vectors (EMU128) are arrays, which __builtin_shufflevector does not take.
#undef SINEW_BLENDS_BY_CONSTANTS
#if defined(__has_builtin) && HWY_TARGET != HWY_EMU128
#if __has_builtin(__builtin_shufflevector)
#define SINEW_BLENDS_BY_CONSTANTS
#endif
#endif

#ifdef SINEW_BLENDS_BY_CONSTANTS

template <std::size_t... kLanes>
HWY_INLINE Wide blend3(Wide a, Wide b, Wide c, std::index_sequence<kLanes...>) {
  constexpr int kSecond = kTileSize;
  Wide bc, abc;
  bc.raw = __builtin_shufflevector(b.raw, c.raw, (kLanes % 3 == 2 ? kSecond : 0) + static_cast<int>(kLanes)...);
  abc.raw = __builtin_shufflevector(a.raw, bc.raw, (kLanes % 3 == 0 ? 0 : kSecond) + static_cast<int>(kLanes)...);
  return abc;
}

HWY_INLINE Wide blend3(Wide a, Wide b, Wide c) { return blend3(a, b, c, std::make_index_sequence<kTileSize>()); }

#else

/// All bits set in the lanes i with i % 3 == kClass.
template <std::size_t kClass>
struct LanesOfClass {
  HWY_ALIGN std::uint32_t all[kTileSize];
  constexpr LanesOfClass() : all() {
    for (std::size_t i = 0; i < kTileSize; ++i) all[i] = i % 3 == kClass ? ~0u : 0u;
  }
};

template <std::size_t kClass>
HWY_INLINE Wide blend_class(Wide yes, Wide no) {
  const TileTag d;
  static constexpr LanesOfClass<kClass> kLanes;
  const hn::RebindToUnsigned<TileTag> bits;
  return hn::IfThenElse(hn::MaskFromVec(hn::BitCast(d, hn::Load(bits, kLanes.all))), yes, no);
}

HWY_INLINE Wide blend3(Wide a, Wide b, Wide c) { return blend_class<0>(a, blend_class<1>(b, c)); }

#endif  // SINEW_BLENDS_BY_CONSTANTS

/// Lane i takes lane i + kBy, wrapping around.
template <std::size_t kBy>
HWY_INLINE Wide rotated(Wide v) {
  if constexpr (kTileSize == 4) {
    if constexpr (kBy == 1) return hn::Shuffle0321(v);
    if constexpr (kBy == 2) return hn::Shuffle1032(v);
    if constexpr (kBy == 3) return hn::Shuffle2103(v);
  } else {
    struct Table {
      HWY_ALIGN std::int32_t of[kTileSize];
      constexpr Table() : of() {
        for (std::size_t i = 0; i < kTileSize; ++i) of[i] = static_cast<std::int32_t>((i + kBy) % kTileSize);
      }
    };
    static constexpr Table kTable;
    return hn::TableLookupLanes(v, hn::SetTableIndices(TileTag(), kTable.of));
  }
}

/// Index of the third that holds x in lanes i with i % 3 = 0, 1 and 2.
constexpr std::size_t kThirdOfX[3] = {0, kTileSize % 3 == 2 ? 1u : 2u, kTileSize % 3 == 2 ? 2u : 1u};

HWY_INLINE Lanes3 lanes_of(const Triples& t) {
  const Wide a = t.thirds[kThirdOfX[0]], b = t.thirds[kThirdOfX[1]], c = t.thirds[kThirdOfX[2]];
  return {blend3(a, b, c), rotated<1>(blend3(c, a, b)), rotated<2>(blend3(b, c, a))};
}

HWY_INLINE Triples triples_of(const Lanes3& v) {
  const Wide y = rotated<kTileSize - 1>(v.y), z = rotated<kTileSize - 2>(v.z);
  Triples t;
  t.thirds[kThirdOfX[0]] = blend3(v.x, y, z);
  t.thirds[kThirdOfX[1]] = blend3(z, v.x, y);
  t.thirds[kThirdOfX[2]] = blend3(y, z, v.x);
  return t;
}

#endif  // HWY_TARGET

HWY_INLINE Triples load_triples(const glm::vec3* tile) {
  const TileTag d;
  const float* at = &tile->x;
  return {{hn::LoadU(d, at), hn::LoadU(d, at + kTileSize), hn::LoadU(d, at + 2 * kTileSize)}};
}

HWY_INLINE Triples minus(const Triples& a, const Triples& b) {
  return {{hn::Sub(a.thirds[0], b.thirds[0]), hn::Sub(a.thirds[1], b.thirds[1]), hn::Sub(a.thirds[2], b.thirds[2])}};
}

/// Stores a tile of packed vec3. Use `past_caches` (non-temporal stores) only if `tile` is aligned to vectors.
HWY_INLINE void store_triples(const Triples& t, glm::vec3* tile, bool past_caches = false) {
  const TileTag d;
  float* to = &tile->x;
  for (std::size_t i = 0; i < 3; ++i)
    if (past_caches)
      hn::Stream(t.thirds[i], d, to + i * kTileSize);
    else
      hn::StoreU(t.thirds[i], d, to + i * kTileSize);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
