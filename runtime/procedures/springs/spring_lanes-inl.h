// SPDX-License-Identifier: MIT
// Directions and turns in double precision, one joint per lane. Included once per SIMD target, so without
// `#pragma once`.
#if defined(SINEW_SPRING_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SPRING_LANES_INL_H
#undef SINEW_SPRING_LANES_INL_H
#else
#define SINEW_SPRING_LANES_INL_H
#endif

#include "runtime/math/lane_vectors-inl.h"
#include "runtime/procedures/springs/spring_slots.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Reads the planes from `first` on.
template <class D>
HWY_INLINE Vector<D> load_vector(D d, springs::Planes<const double> from, std::size_t first, std::size_t i) {
  return {hn::LoadU(d, from.plane(first) + i), hn::LoadU(d, from.plane(first + 1) + i),
          hn::LoadU(d, from.plane(first + 2) + i)};
}
template <class D>
HWY_INLINE Rotation<D> load_rotation(D d, springs::Planes<const double> from, std::size_t first, std::size_t i) {
  const Vector<D> v = load_vector(d, from, first, i);
  return {v.x, v.y, v.z, hn::LoadU(d, from.plane(first + 3) + i)};
}
template <class D>
HWY_INLINE void store_vector(D d, const Vector<D>& v, springs::Planes<double> to, std::size_t first, std::size_t i) {
  hn::StoreU(v.x, d, to.plane(first) + i);
  hn::StoreU(v.y, d, to.plane(first + 1) + i);
  hn::StoreU(v.z, d, to.plane(first + 2) + i);
}

/// Unit vector along v, or `fallback` if v is too short to have a direction.
template <class D>
HWY_INLINE Vector<D> direction_or(D d, const Vector<D>& v, const Vector<D>& fallback) {
  const hn::Vec<D> square = dot<D>(v, v);
  const hn::Mask<D> has_direction = hn::Gt(square, hn::Set(d, 1e-200));
  const hn::Vec<D> safe = hn::IfThenElse(has_direction, square, hn::Set(d, 1.0));
  return either<D>(has_direction, times<D>(v, per_root(d, safe)), fallback);
}

/// Shortest rotation between unit vectors.
/// eq   (from x to, 1 + from . to), normalised   (Real-Time Rendering, eq. 4.58); a half turn for opposite vectors
template <class D>
HWY_INLINE Rotation<D> shortest_turn(D d, const Vector<D>& from, const Vector<D>& to) {
  const hn::Vec<D> one = hn::Set(d, 1.0), zero = hn::Zero(d), w = hn::Add(one, dot<D>(from, to));
  const hn::Mask<D> is_opposite = hn::Lt(w, hn::Set(d, 1e-7));
  const Vector<D> v = cross<D>(from, to);
  const hn::Vec<D> square = hn::Add(dot<D>(v, v), hn::Mul(w, w));
  const Rotation<D> turn = scaled<D>({v.x, v.y, v.z, w}, per_root(d, hn::IfThenElse(is_opposite, one, square)));
  if (HWY_LIKELY(hn::AllFalse(d, is_opposite))) return turn;
  const hn::Vec<D> x = hn::Abs(from.x), y = hn::Abs(from.y), z = hn::Abs(from.z);
  const hn::Mask<D> least_x = hn::And(hn::Le(x, y), hn::Le(x, z)), least_y = hn::AndNot(least_x, hn::Le(y, z));
  const hn::Mask<D> least_z = hn::Not(hn::Or(least_x, least_y));
  const Vector<D> least{hn::IfThenElseZero(least_x, one), hn::IfThenElseZero(least_y, one),
                        hn::IfThenElseZero(least_z, one)};
  const Vector<D> axis = direction_or<D>(d, cross<D>(from, least), least);
  return {hn::IfThenElse(is_opposite, axis.x, turn.x), hn::IfThenElse(is_opposite, axis.y, turn.y),
          hn::IfThenElse(is_opposite, axis.z, turn.z), hn::IfThenElse(is_opposite, zero, turn.w)};
}

/// A joint turned away from its goal, so that its bone points along a world direction.
template <class Frames, class D>
struct Swung {
  Frames frame;
  Rotation<D> local;  ///< rotation of the turned joint in its parent's space
};

/// in   goal         frame of the joint at its goal, without its own scale;   goal_rotation  its local rotation
///      axis, along  unit: direction of the bone at the goal, and after the turn;   local_axis  of the bone in the
///      joint

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
