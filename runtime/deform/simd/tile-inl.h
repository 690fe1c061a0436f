// SPDX-License-Identifier: MIT
// A tile: as many vertices as a vector of up to 512 bits has lanes. Included once per SIMD target (Highway's
// foreach_target), hence the guard's form.
#if defined(SINEW_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TILE_INL_H_
#undef SINEW_TILE_INL_H_
#else
#define SINEW_TILE_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>

#include "runtime/math/conventions.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using TileTag = hn::CappedTag<float, 16>;
using Wide = hn::Vec<TileTag>;
constexpr std::size_t kTileSize = hn::MaxLanes(TileTag());

/// Squares of lengths that divide without loss of digits.
HWY_INLINE hn::Mask<TileTag> keeps_digits(Wide squared) {
  const TileTag d;
  return hn::And(hn::Gt(squared, hn::Set(d, 1e-30f)), hn::Lt(squared, hn::Set(d, 1e30f)));
}

/// Calls `body(vertex of the tile)` for all, four in a row: the loop's own steps are a tenth of what a blend takes.
template <class Body>
HWY_INLINE void for_each_of_tile(const Body& body) {
  constexpr std::size_t kRow = kTileSize < 4 ? kTileSize : 4;
  for (std::size_t first = 0; first < kTileSize; first += kRow)
    for (std::size_t k = first; k < first + kRow; ++k) body(k);
}

/// The same in rows that a compiler does not unroll: what `body` leaves in registers would not fit them for a whole
/// tile.
template <class Body>
HWY_INLINE void for_each_of_tile_by_rows(const Body& body) {
  constexpr std::size_t kRow = kTileSize < 4 ? kTileSize : 4;
#if HWY_COMPILER_GCC_ACTUAL
#pragma GCC unroll 1
#endif
  for (std::size_t first = 0; first < kTileSize; first += kRow)
    for (std::size_t k = first; k < first + kRow; ++k) body(k);
}

/// Calls `body(lane)` for the lanes that are not in the mask, which are few and far between.
template <class Body>
HWY_INLINE void for_each_lane_not_in(hn::Mask<TileTag> mask, const Body& body) {
  const TileTag d;
  if (HWY_LIKELY(hn::AllTrue(d, mask))) return;
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, hn::Not(mask), bits);
  for (unsigned left = bits[0] | unsigned{bits[1]} << 8; left != 0; left &= left - 1)
    body(static_cast<std::size_t>(std::countr_zero(left)));
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
