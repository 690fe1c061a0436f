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

/// The rotation about t by four times the length of t. It is the square of a rotation by half that angle, so short
/// Taylor series suffice for half a turn.
/// in   t  [rad] up to an eighth of a turn;   acc  2e-7
HWY_INLINE Rotations rotation_by_quarter(Lanes x, Lanes y, Lanes z) {
  const Floats d;
  constexpr float kSine[] = {1.0f / 362880, -1.0f / 5040, 1.0f / 120, -1.0f / 6, 1.0f};
  constexpr float kCosine[] = {1.0f / 40320, -1.0f / 720, 1.0f / 24, -0.5f, 1.0f};
  const Lanes angle2 = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
  const Lanes sine = polynomial(angle2, kSine), cosine = polynomial(angle2, kCosine);
  const Lanes twice = hn::Add(sine, sine), by = hn::Mul(cosine, twice);
  return {hn::Mul(x, by), hn::Mul(y, by), hn::Mul(z, by),
          hn::Sub(hn::Set(d, 1.0f), hn::Mul(hn::Mul(sine, twice), angle2))};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
