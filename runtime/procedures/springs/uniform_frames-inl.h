// SPDX-License-Identifier: MIT
// World transforms of joints with uniform scales, one joint per lane. Included once per SIMD target, so without
// `#pragma once`.
#if defined(SINEW_UNIFORM_FRAMES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_UNIFORM_FRAMES_INL_H
#undef SINEW_UNIFORM_FRAMES_INL_H
#else
#define SINEW_UNIFORM_FRAMES_INL_H
#endif

#include "runtime/procedures/springs/spring_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// World transforms of joints if all scales above them are uniform: position, rotation, and a signed scale factor.
template <class D>
struct UniformFrames {
  Vector<D> at;
  Rotation<D> rotation;
  hn::Vec<D> scale;

  /// in   read(p)  the lanes of plane p
  template <class Read>
  static HWY_INLINE UniformFrames read_planes(const Read& read) {
    return {{read(0), read(1), read(2)}, {read(3), read(4), read(5), read(6)}, read(7)};
  }
  template <class Write>
  HWY_INLINE void write_planes(const Write& write) const {
    const hn::Vec<D> all[] = {at.x, at.y, at.z, rotation.x, rotation.y, rotation.z, rotation.w, scale};
    for (std::size_t p = 0; p < 8; ++p) write(p, all[p]);
  }
  HWY_INLINE UniformFrames or_else(hn::Mask<D> mask, const UniformFrames& other) const {
    return {either<D>(mask, at, other.at),
            {hn::IfThenElse(mask, rotation.x, other.rotation.x), hn::IfThenElse(mask, rotation.y, other.rotation.y),
             hn::IfThenElse(mask, rotation.z, other.rotation.z), hn::IfThenElse(mask, rotation.w, other.rotation.w)},
            hn::IfThenElse(mask, scale, other.scale)};
  }

  HWY_INLINE hn::Vec<D> sign(D d) const { return hn::CopySign(hn::Set(d, 1.0), scale); }
  HWY_INLINE Vector<D> vector(D, const Vector<D>& v) const { return times<D>(rotated<D>(rotation, v), scale); }
  HWY_INLINE Vector<D> point(D d, const Vector<D>& p) const { return plus<D>(at, vector(d, p)); }
  HWY_INLINE Vector<D> local_point(D d, const Vector<D>& p) const {
    const hn::Mask<D> is_flat = hn::Eq(scale, hn::Zero(d));
    const hn::Vec<D> per_scale = hn::Div(hn::Set(d, 1.0), hn::IfThenElse(is_flat, hn::Set(d, 1.0), scale));
    return times<D>(rotated<D>(conjugate<D>(rotation), minus<D>(p, at)), hn::IfThenZeroElse(is_flat, per_scale));
  }

  /// Length and direction of a vector after the transform, given its own length and direction.
  HWY_INLINE hn::Vec<D> length_of(D, const Vector<D>&, hn::Vec<D> length) const {
    return hn::Mul(hn::Abs(scale), length);
  }
  HWY_INLINE Vector<D> direction_along(D d, const Vector<D>&, const Vector<D>& axis) const {
    return times<D>(rotated<D>(rotation, axis), sign(d));
  }
  /// A vector of any length that the transform turns to the direction `v`.
  HWY_INLINE Vector<D> local_direction(D d, const Vector<D>& v) const {
    return times<D>(rotated<D>(conjugate<D>(rotation), v), sign(d));
  }
  HWY_INLINE UniformFrames child(D d, const Vector<D>& translation, const Rotation<D>& local) const {
    return {point(d, translation), product<D>(rotation, local), scale};
  }
  HWY_INLINE UniformFrames turned(D, const Rotation<D>& local) const {
    return {at, product<D>(rotation, local), scale};
  }
  HWY_INLINE UniformFrames scaled_by(const Vector<D>& factors) const {
    return {at, rotation, hn::Mul(scale, factors.x)};
  }
};

template <class D>
HWY_INLINE Swung<UniformFrames<D>, D> swung(D d, const UniformFrames<D>& above, const UniformFrames<D>& goal,
                                            const Rotation<D>&, const Vector<D>&, const Vector<D>& axis,
                                            const Vector<D>& along) {
  const Rotation<D> turned = product<D>(shortest_turn<D>(d, axis, along), goal.rotation);
  return {{goal.at, turned, goal.scale}, product<D>(conjugate<D>(above.rotation), turned)};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
