// SPDX-License-Identifier: MIT
// Rotations from rotation vectors, one joint per lane. Included once per SIMD target, so without `#pragma once`.
#if defined(SINEW_TURN_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TURN_LANES_INL_H
#undef SINEW_TURN_LANES_INL_H
#else
#define SINEW_TURN_LANES_INL_H
#endif

#include "runtime/pose/simd/pose_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Horner's rule, never fused.     in   coefficients  of the highest power first
template <std::size_t kCount>
HWY_INLINE Lanes polynomial(Lanes x, const float (&coefficients)[kCount]) {
  const Floats d;
  Lanes sum = hn::Set(d, coefficients[0]);
  for (std::size_t i = 1; i < kCount; ++i) sum = hn::Add(hn::Mul(sum, x), hn::Set(d, coefficients[i]));
  return sum;
}

/// The rotation by an angle of |t| about t. It is the square of the rotation by half that angle, so that short Taylor
/// series reach half a turn.
/// in   t  [rad] up to half a turn;   acc  2e-7
HWY_INLINE Rotations rotation_by(Lanes tx, Lanes ty, Lanes tz) {
  const Floats d;
  constexpr float kSine[] = {1.0f / 362880, -1.0f / 5040, 1.0f / 120, -1.0f / 6, 1.0f};
  constexpr float kCosine[] = {-1.0f / 3628800, 1.0f / 40320, -1.0f / 720, 1.0f / 24, -0.5f, 1.0f};
  const Lanes quarter = hn::Set(d, 0.25f), one = hn::Set(d, 1.0f), two = hn::Set(d, 2.0f);
  const Lanes x = hn::Mul(tx, quarter), y = hn::Mul(ty, quarter), z = hn::Mul(tz, quarter);
  const Lanes angle2 = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
  const Lanes sine = polynomial(angle2, kSine), cosine = polynomial(angle2, kCosine);
  const Lanes by = hn::Mul(hn::Mul(two, cosine), sine);
  const Lanes sine2 = hn::Mul(hn::Mul(sine, sine), angle2);
  return {hn::Mul(x, by), hn::Mul(y, by), hn::Mul(z, by), hn::Sub(one, hn::Mul(two, sine2))};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
