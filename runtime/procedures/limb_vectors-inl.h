// SPDX-License-Identifier: MIT
// Frames and rotations of limbs, one per lane of any vector type. Included once per SIMD target, so without
// `#pragma once`.
#if defined(SINEW_LIMB_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LIMB_VECTORS_INL_H
#undef SINEW_LIMB_VECTORS_INL_H
#else
#define SINEW_LIMB_VECTORS_INL_H
#endif

#include "runtime/math/lane_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Unit and perpendicular vectors, as ik::Frame.
template <class D>
struct Frame {
  Vector<D> along, side;
};

/// Makes the vectors of two frames unit, with one division for all four lengths.
template <class D>
HWY_INLINE void make_unit(D d, Frame<D>& a, Frame<D>& b) {
  const hn::Vec<D> lengths[] = {hn::Sqrt(dot<D>(a.along, a.along)), hn::Sqrt(dot<D>(a.side, a.side)),
                                hn::Sqrt(dot<D>(b.along, b.along)), hn::Sqrt(dot<D>(b.side, b.side))};
  const hn::Vec<D> of_a = hn::Mul(lengths[0], lengths[1]), of_b = hn::Mul(lengths[2], lengths[3]);
  const hn::Vec<D> per_all = hn::Div(hn::Set(d, 1.0), hn::Mul(of_a, of_b));
  const hn::Vec<D> per_a = hn::Mul(per_all, of_b), per_b = hn::Mul(per_all, of_a);
  a = {times<D>(a.along, hn::Mul(per_a, lengths[1])), times<D>(a.side, hn::Mul(per_a, lengths[0]))};
  b = {times<D>(b.along, hn::Mul(per_b, lengths[3])), times<D>(b.side, hn::Mul(per_b, lengths[2]))};
}

/// The unit quaternion along q; the identity where q has no direction.
template <class D>
HWY_INLINE Rotation<D> unit(D d, const Rotation<D>& q) {
  const hn::Vec<D> square = dot<D>(q, q);
  const hn::Mask<D> has_direction = hn::Gt(square, hn::Set(d, 1e-20));
  const Rotation<D> u = scaled<D>(q, per_root(d, square));
  return {hn::IfThenElseZero(has_direction, u.x), hn::IfThenElseZero(has_direction, u.y),
          hn::IfThenElseZero(has_direction, u.z), hn::IfThenElse(has_direction, u.w, hn::Set(d, 1.0))};
}
/// A quaternion of nearly unit length, nearer to it.
/// eq   one step of Newton's method for 1 / |q|, without a root or division: |q|^2 - 1 = e becomes 3/4 e^2
template <class D>
HWY_INLINE Rotation<D> unit_again(D d, const Rotation<D>& q) {
  return scaled<D>(q, hn::Sub(hn::Set(d, 1.5), hn::Mul(hn::Set(d, 0.5), dot<D>(q, q))));
}
/// On the hemisphere of `reference`.
template <class D>
HWY_INLINE Rotation<D> aligned(D d, const Rotation<D>& reference, const Rotation<D>& q) {
  const hn::Mask<D> is_other = hn::Lt(dot<D>(reference, q), hn::Zero(d));
  return scaled<D>(q, hn::IfThenElse(is_other, hn::Set(d, -1.0), hn::Set(d, 1.0)));
}
/// Rounded to float.
template <class D>
HWY_INLINE Rotation<D> stored(D d, const Rotation<D>& q) {
  const hn::Rebind<float, D> f;
  const auto round = [&](hn::Vec<D> v) HWY_ATTR { return hn::PromoteTo(d, hn::DemoteTo(f, v)); };
  return {round(q.x), round(q.y), round(q.z), round(q.w)};
}

/// eq   ik::turn_about: half angles by square roots
/// in   cosine, sine  of the angle
template <class D>
HWY_INLINE Rotation<D> turn_about(D d, const Vector<D>& axis, hn::Vec<D> cosine, hn::Vec<D> sine) {
  const hn::Vec<D> half = hn::Set(d, 0.5);
  const hn::Vec<D> large = hn::Sqrt(hn::Mul(half, hn::Add(hn::Set(d, 1.0), hn::Abs(cosine))));
  const hn::Vec<D> small = hn::Div(hn::Mul(half, sine), large);
  const hn::Mask<D> is_acute = hn::Ge(cosine, hn::Zero(d));
  const Vector<D> v = times<D>(axis, hn::IfThenElse(is_acute, small, large));
  return {v.x, v.y, v.z, hn::IfThenElse(is_acute, large, small)};
}

/// The rotation that turns one frame onto another.
/// eq   the quaternion of the matrix to from^T, as quat_from_matrix: of its four forms the one with the largest divisor
template <class D>
HWY_INLINE Rotation<D> turn_between(D d, const Frame<D>& from, const Frame<D>& to) {
  const Vector<D> from_third = cross<D>(from.along, from.side), to_third = cross<D>(to.along, to.side);
  const auto column = [&](hn::Vec<D> x, hn::Vec<D> y, hn::Vec<D> z) HWY_ATTR {
    return plus<D>(plus<D>(times<D>(to.along, x), times<D>(to.side, y)), times<D>(to_third, z));
  };
  const Vector<D> x = column(from.along.x, from.side.x, from_third.x),
                  y = column(from.along.y, from.side.y, from_third.y),
                  z = column(from.along.z, from.side.z, from_third.z);
  const hn::Vec<D> one = hn::Set(d, 1.0);
  const hn::Vec<D> ww = hn::Add(one, hn::Add(x.x, hn::Add(y.y, z.z))),
                   xx = hn::Add(one, hn::Sub(x.x, hn::Add(y.y, z.z))),
                   yy = hn::Add(one, hn::Sub(y.y, hn::Add(x.x, z.z))),
                   zz = hn::Add(one, hn::Sub(z.z, hn::Add(x.x, y.y)));
  const hn::Vec<D> wx = hn::Sub(y.z, z.y), wy = hn::Sub(z.x, x.z), wz = hn::Sub(x.y, y.x);
  const hn::Vec<D> xy = hn::Add(x.y, y.x), xz = hn::Add(x.z, z.x), yz = hn::Add(y.z, z.y);
  const hn::Vec<D> largest = hn::Max(hn::Max(ww, xx), hn::Max(yy, zz));
  const auto pick = [&](hn::Vec<D> w, hn::Vec<D> by_x, hn::Vec<D> by_y, hn::Vec<D> by_z) HWY_ATTR {
    const hn::Vec<D> last = hn::IfThenElse(hn::Eq(yy, largest), by_y, by_z);
    return hn::IfThenElse(hn::Eq(ww, largest), w, hn::IfThenElse(hn::Eq(xx, largest), by_x, last));
  };
  return unit<D>(d, {pick(wx, xx, xy, xz), pick(wy, xy, yy, yz), pick(wz, xz, yz, zz), pick(ww, wx, wy, wz)});
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
