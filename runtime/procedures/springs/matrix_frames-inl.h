// SPDX-License-Identifier: MIT
// World transforms of joints with scales of any kind, one joint per lane. Included once per SIMD target, so without
// `#pragma once`.
#if defined(SINEW_MATRIX_FRAMES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_MATRIX_FRAMES_INL_H
#undef SINEW_MATRIX_FRAMES_INL_H
#else
#define SINEW_MATRIX_FRAMES_INL_H
#endif

#include "runtime/procedures/springs/spring_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// World transforms of joints for scales of any kind. Such scales shear joints that are rotated below them.
template <class D>
struct MatrixFrames {
  Vector<D> at, column[3];

  template <class Read>
  static HWY_INLINE MatrixFrames read_planes(const Read& read) {
    return {{read(0), read(1), read(2)},
            {{read(3), read(4), read(5)}, {read(6), read(7), read(8)}, {read(9), read(10), read(11)}}};
  }
  template <class Write>
  HWY_INLINE void write_planes(const Write& write) const {
    const Vector<D>* all[] = {&at, &column[0], &column[1], &column[2]};
    for (std::size_t v = 0; v < 4; ++v) {
      write(3 * v, all[v]->x);
      write(3 * v + 1, all[v]->y);
      write(3 * v + 2, all[v]->z);
    }
  }
  HWY_INLINE MatrixFrames or_else(hn::Mask<D> mask, const MatrixFrames& other) const {
    return {either<D>(mask, at, other.at),
            {either<D>(mask, column[0], other.column[0]), either<D>(mask, column[1], other.column[1]),
             either<D>(mask, column[2], other.column[2])}};
  }

  HWY_INLINE Vector<D> vector(D, const Vector<D>& v) const {
    return plus<D>(plus<D>(times<D>(column[0], v.x), times<D>(column[1], v.y)), times<D>(column[2], v.z));
  }
  HWY_INLINE Vector<D> point(D d, const Vector<D>& p) const { return plus<D>(at, vector(d, p)); }
  /// eq   the transposed cofactors times v: the inverse times the determinant
  HWY_INLINE Vector<D> by_cofactors(const Vector<D>& v) const {
    return {dot<D>(cross<D>(column[1], column[2]), v), dot<D>(cross<D>(column[2], column[0]), v),
            dot<D>(cross<D>(column[0], column[1]), v)};
  }
  HWY_INLINE hn::Vec<D> determinant() const { return dot<D>(column[0], cross<D>(column[1], column[2])); }
  HWY_INLINE Vector<D> local_point(D d, const Vector<D>& p) const {
    const hn::Vec<D> det = determinant();
    const hn::Mask<D> is_flat = hn::Eq(det, hn::Zero(d));
    const hn::Vec<D> per_det = hn::Div(hn::Set(d, 1.0), hn::IfThenElse(is_flat, hn::Set(d, 1.0), det));
    return times<D>(by_cofactors(minus<D>(p, at)), hn::IfThenZeroElse(is_flat, per_det));
  }
  HWY_INLINE hn::Vec<D> length_of(D d, const Vector<D>& v, hn::Vec<D>) const {
    const Vector<D> image = vector(d, v);
    return hn::Sqrt(dot<D>(image, image));
  }
  HWY_INLINE Vector<D> direction_along(D d, const Vector<D>& v, const Vector<D>&) const {
    return direction_or<D>(d, vector(d, v), {hn::Zero(d), hn::Set(d, 1.0), hn::Zero(d)});
  }
  HWY_INLINE Vector<D> local_direction(D d, const Vector<D>& v) const {
    return times<D>(by_cofactors(v), hn::CopySign(hn::Set(d, 1.0), determinant()));
  }
  HWY_INLINE MatrixFrames child(D d, const Vector<D>& translation, const Rotation<D>& local) const {
    MatrixFrames out = turned(d, local);
    out.at = point(d, translation);
    return out;
  }
  HWY_INLINE MatrixFrames turned(D d, const Rotation<D>& local) const {
    const hn::Vec<D> one = hn::Set(d, 1.0), zero = hn::Zero(d);
    return {at,
            {vector(d, rotated<D>(local, {one, zero, zero})), vector(d, rotated<D>(local, {zero, one, zero})),
             vector(d, rotated<D>(local, {zero, zero, one}))}};
  }
  HWY_INLINE MatrixFrames scaled_by(const Vector<D>& factors) const {
    return {at, {times<D>(column[0], factors.x), times<D>(column[1], factors.y), times<D>(column[2], factors.z)}};
  }
};

template <class D>
HWY_INLINE Swung<MatrixFrames<D>, D> swung(D d, const MatrixFrames<D>&, const MatrixFrames<D>& goal,
                                           const Rotation<D>& goal_rotation, const Vector<D>& local_axis,
                                           const Vector<D>&, const Vector<D>& along) {
  const Vector<D> local = direction_or<D>(d, goal.local_direction(d, along), local_axis);
  const Rotation<D> swing = shortest_turn<D>(d, local_axis, local);
  return {goal.turned(d, swing), product<D>(goal_rotation, swing)};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
