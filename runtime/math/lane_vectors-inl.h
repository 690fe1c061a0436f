// SPDX-License-Identifier: MIT
// Vectors and rotations in double precision, one per lane of any vector type. Included once per SIMD target, so
// without `#pragma once`. Multiplications and additions are never fused, so all targets give the same bits.
#if defined(SINEW_LANE_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANE_VECTORS_INL_H
#undef SINEW_LANE_VECTORS_INL_H
#else
#define SINEW_LANE_VECTORS_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct Vector {
  hn::Vec<D> x, y, z;
};
template <class D>
struct Rotation {
  hn::Vec<D> x, y, z, w;
};
template <class D>
HWY_INLINE hn::Vec<D> dot(const Vector<D>& a, const Vector<D>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
template <class D>
HWY_INLINE Vector<D> cross(const Vector<D>& a, const Vector<D>& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
template <class D>
HWY_INLINE Vector<D> times(const Vector<D>& a, hn::Vec<D> s) {
  return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
template <class D>
HWY_INLINE Vector<D> plus(const Vector<D>& a, const Vector<D>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
template <class D>
HWY_INLINE Vector<D> minus(const Vector<D>& a, const Vector<D>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class D>
HWY_INLINE Vector<D> either(hn::Mask<D> mask, const Vector<D>& yes, const Vector<D>& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}
/// eq   1 / sqrt(square)
template <class D>
HWY_INLINE hn::Vec<D> per_root(D d, hn::Vec<D> square) {
  return hn::Div(hn::Set(d, 1.0), hn::Sqrt(square));
}

/// eq   sinew::rotate_vector, for a unit quaternion
template <class D>
HWY_INLINE Vector<D> rotated(const Rotation<D>& q, const Vector<D>& p) {
  const Vector<D> v{q.x, q.y, q.z}, once = cross<D>(v, p), twice = plus<D>(once, once);
  return plus<D>(plus<D>(p, times<D>(twice, q.w)), cross<D>(v, twice));
}
template <class D>
HWY_INLINE Rotation<D> conjugate(const Rotation<D>& q) {
  return {hn::Neg(q.x), hn::Neg(q.y), hn::Neg(q.z), q.w};
}
/// eq   a b: b is applied first
template <class D>
HWY_INLINE Rotation<D> product(const Rotation<D>& a, const Rotation<D>& b) {
  const Vector<D> u{a.x, a.y, a.z}, v{b.x, b.y, b.z};
  const Vector<D> sum = plus<D>(plus<D>(times<D>(v, a.w), times<D>(u, b.w)), cross<D>(u, v));
  return {sum.x, sum.y, sum.z, hn::Sub(hn::Mul(a.w, b.w), dot<D>(u, v))};
}
template <class D>
HWY_INLINE hn::Vec<D> dot(const Rotation<D>& a, const Rotation<D>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Add(hn::Mul(a.z, b.z), hn::Mul(a.w, b.w)));
}
template <class D>
HWY_INLINE Rotation<D> scaled(const Rotation<D>& q, hn::Vec<D> s) {
  return {hn::Mul(q.x, s), hn::Mul(q.y, s), hn::Mul(q.z, s), hn::Mul(q.w, s)};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
