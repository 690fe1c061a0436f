// SPDX-License-Identifier: MIT
// A tile: as many vertices as a vector of up to 512 bits has lanes. Included once per SIMD target (Highway's
// foreach_target), hence the unusual include guard.
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

#if HWY_TARGET != HWY_SCALAR

/// Copies lane `kLane` of each 128-bit block to all lanes of the block. SSE4 shuffles integers, because its float
/// shuffle would need a register copy.
template <int kLane>
HWY_INLINE Wide broadcast(Wide v) {
#if HWY_TARGET == HWY_SSE4
  const hn::RebindToSigned<TileTag> d;
  return hn::BitCast(TileTag(), hn::Broadcast<kLane>(hn::BitCast(d, v)));
#else
  return hn::Broadcast<kLane>(v);
#endif
}

#endif  // HWY_TARGET

/// Lanes whose squared length is in the range in which dividing by the length loses no digits.
HWY_INLINE hn::Mask<TileTag> keeps_digits(Wide squared) {
  const TileTag d;
  return hn::And(hn::Gt(squared, hn::Set(d, 1e-30f)), hn::Lt(squared, hn::Set(d, 1e30f)));
}

/// Turns normals that were moved by cofactors to the outside, by the sign of the determinant.
/// eq   |det| > 8 u F^3 + 1e-36, u = 2^-24, F the Frobenius norm of the matrix M: where this holds, float has the right
///      sign, and the normal the right side. Rounding changes the determinant by at most 5 u times the permanent of
///      |M|, which is at most 0.223 F^3. It changes the normal by at most 3.1 u F^2, and the normal is at least 8 u F^2
///      long, since F is not less than the largest singular value. The constant covers products that underflow.
/// Where this does not hold, the scalar path computes the lane with the exact sign (determinant_sign.h). Callers keep
/// the mask, or set the normal to zero, which keeps_digits rejects.
class OutwardSide {
 public:
  HWY_INLINE OutwardSide(Wide determinant, Wide squared_norm) {
    const TileTag d;
    const Wide cube = hn::Mul(squared_norm, hn::Sqrt(squared_norm));
    certain_ = hn::Gt(hn::Abs(determinant), hn::MulAdd(cube, hn::Set(d, 0x8p-24f), hn::Set(d, 1e-36f)));
    sign_ = hn::And(determinant, hn::SignBit(d));
  }
  HWY_INLINE hn::Mask<TileTag> certain() const { return certain_; }
  /// The normal, negated where the determinant is negative. Its side may be wrong in lanes that are not certain().
  HWY_INLINE Wide turned(Wide normal) const { return hn::Xor(normal, sign_); }
  /// As turned(), but zero in lanes that are not certain().
  HWY_INLINE Wide turn(Wide normal) const { return hn::IfThenElseZero(certain_, turned(normal)); }

 private:
  hn::Mask<TileTag> certain_;
  Wide sign_;
};

/// Calls `body(vertex of the tile)` for all vertices. The loop is unrolled by four, since its own cost is a tenth of a
/// blend.
template <class Body>
HWY_INLINE void for_each_of_tile(const Body& body) {
  constexpr std::size_t kRow = kTileSize < 4 ? kTileSize : 4;
  for (std::size_t first = 0; first < kTileSize; first += kRow)
    for (std::size_t k = first; k < first + kRow; ++k) body(k);
}

/// Same, but the steps are not unrolled. For bodies whose results for a whole tile exceed the registers.
template <class Body>
HWY_INLINE void for_each_of_tile_by_rows(const Body& body) {
  constexpr std::size_t kRow = kTileSize < 4 ? kTileSize : 4;
#if HWY_COMPILER_GCC_ACTUAL
#pragma GCC unroll 1
#endif
  for (std::size_t first = 0; first < kTileSize; first += kRow)
    for (std::size_t k = first; k < first + kRow; ++k) body(k);
}

/// Calls `body(lane)` for each lane that is not in the mask. Such lanes are rare.
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
