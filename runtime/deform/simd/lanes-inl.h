// SPDX-License-Identifier: MIT
// Attributes of a tile as structure of arrays, one vertex per lane.
#if defined(SINEW_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANES_INL_H_
#undef SINEW_LANES_INL_H_
#else
#define SINEW_LANES_INL_H_
#endif

#include "runtime/deform/simd/tile-inl.h"
#include "runtime/pose/simd/transpose-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

struct Lanes3 {
  Wide x, y, z;
};

using Lanes4 = FourVectors<Wide>;

/// Dot product.
/// eq   a.x b.x + a.y b.y + a.z b.z, summed in that order
HWY_INLINE Wide dot(const Lanes3& a, const Lanes3& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}

HWY_INLINE Wide dot(const Lanes4& a, const Lanes4& b) {
  return hn::MulAdd(a.w, b.w, hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x))));
}

HWY_INLINE Lanes3 cross(const Lanes3& a, const Lanes3& b) {
  return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)), hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
          hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}

HWY_INLINE Lanes3 plus(const Lanes3& a, const Lanes3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Lanes3 minus(const Lanes3& a, const Lanes3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Lanes3 times(const Lanes3& a, Wide s) { return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)}; }
HWY_INLINE Lanes4 times(const Lanes4& a, Wide s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s), hn::Mul(a.w, s)};
}

/// Normalises vectors, with an exact square root and division. Returns the lanes whose squared length lies where float
/// keeps its digits. All other lanes need the scalar path.
HWY_INLINE hn::Mask<TileTag> normalise(Lanes3& v) {
  const TileTag d;
  const Wide squared = dot(v, v);
  v = times(v, hn::Div(hn::Set(d, 1.0f), hn::Sqrt(squared)));
  return keeps_digits(squared);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
