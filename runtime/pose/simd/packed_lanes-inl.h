// SPDX-License-Identifier: MIT
// Interpolation of blocks of packed tracks, written once over Highway's lanes; included once per SIMD target, so
// without
// `#pragma once`. Every lane computes its own track by the same single multiplications and additions, never fused: all
// targets give the same bits (N27, N28).
#if defined(SINEW_PACKED_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_PACKED_LANES_INL_H
#undef SINEW_PACKED_LANES_INL_H
#else
#define SINEW_PACKED_LANES_INL_H
#endif

#include "runtime/pose/simd/packed_numbers-inl.h"
#include "runtime/pose/simd/track_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// A component of packed values.
/// eq   number * step + low
HWY_INLINE Lanes value(const TrackBlock& block, Whole whole, std::size_t component, std::size_t lane) {
  const Floats d;
  const std::size_t at = component * block.lane_count + lane;
  const Lanes number = hn::ConvertTo(d, whole);
  return hn::Add(hn::Mul(number, hn::LoadU(d, block.packed.step.data() + at)),
                 hn::LoadU(d, block.packed.low.data() + at));
}

/// eq   (1 - s) v0 + s v1
template <std::size_t kComponents>
HWY_INLINE void lerp_components(const TrackBlock& block, const PackedKeys& keys, const TrackOutput& out) {
  const Floats d;
  const Lanes s = hn::Set(d, keys.s), r = hn::Set(d, keys.r);
  for_each_place(block, out, [&](const auto& place) HWY_ATTR {
    const auto numbers = unpack<kComponents>(block, keys, place.lane());
    for (std::size_t c = 0; c < kComponents; ++c) {
      const Lanes v0 = value(block, numbers.begin[c], c, place.lane()),
                  v1 = value(block, numbers.end[c], c, place.lane());
      place.store(c, hn::Add(hn::Mul(v0, r), hn::Mul(v1, s)));
    }
  });
}

HWY_NOINLINE void lerp_packed(const TrackBlock& block, const PackedKeys& keys, const TrackOutput& out) {
  if (component_count(block.property) == 3)
    lerp_components<3>(block, keys, out);
  else
    lerp_components<1>(block, keys, out);
}

struct QuatLanes {
  Lanes x, y, z, w;
};

/// Packed rotations, whose largest component is not stored.
/// eq   sqrt(1 - sum of the squares of the others); it reads as 0 until it is filled in
HWY_INLINE QuatLanes rotation(const TrackBlock& block, const Whole (&numbers)[4], std::size_t lane) {
  const Floats d;
  const hn::RebindToSigned<Floats> whole;
  const auto derived =
      hn::PromoteTo(whole, hn::LoadU(hn::Rebind<std::uint8_t, Floats>(), block.packed.derived.data() + lane));
  QuatLanes q{value(block, numbers[0], 0, lane), value(block, numbers[1], 1, lane), value(block, numbers[2], 2, lane),
              value(block, numbers[3], 3, lane)};
  const Lanes rest = hn::Sqrt(hn::Max(hn::Sub(hn::Set(d, 1.0f), dot4(q.x, q.y, q.z, q.w)), hn::Zero(d)));
  const auto put = [&](Lanes stored, std::int32_t component) HWY_ATTR {
    return hn::IfThenElse(hn::RebindMask(d, hn::Eq(derived, hn::Set(whole, component))), rest, stored);
  };
  return {put(q.x, 0), put(q.y, 1), put(q.z, 2), put(q.w, 3)};
}

/// eq   c0 + x (c1 + x (c2 + ...))
template <std::size_t kCount>
HWY_INLINE Lanes polynomial(const float (&c)[kCount], Lanes x) {
  const Floats d;
  Lanes p = hn::Set(d, c[kCount - 1]);
  for (std::size_t i = kCount - 1; i-- > 0;) p = hn::Add(hn::Set(d, c[i]), hn::Mul(x, p));
  return p;
}

/// eq   asin(x) / x from x^2, x <= sqrt(1 / 2): largest relative error 1.7e-8 (Chebyshev)
HWY_INLINE Lanes arc_ratio(Lanes squared) {
  constexpr float kCoefficients[] = {0.999999986f,  0.166670064f,  0.0748637406f,  0.0466991604f,
                                     0.0154330447f, 0.0794899394f, -0.0960293607f, 0.113178817f};
  return polynomial(kCoefficients, squared);
}

/// eq   sin(x) / x from x^2, x <= pi / 2: the polynomial of `sine`
HWY_INLINE Lanes sine_ratio(Lanes squared) {
  constexpr float kCoefficients[] = {0.999999994686f, -0.16666656684f, 0.00833302513895f, -0.000198074187248f,
                                     2.60190306065e-6f};
  return polynomial(kCoefficients, squared);
}

/// Slerp along the shorter arc of packed keys (G01).
/// eq   normalise(q0 sin(r a) + q1 sin(s a)), a = 2 asin(|q1 - q0| / 2). Both weights are divided by a, so that only
///      its square is needed and no arc is too small (N01).
HWY_NOINLINE void slerp_packed(const TrackBlock& block, const PackedKeys& keys, const TrackOutput& out) {
  const Floats d;
  const Lanes s = hn::Set(d, keys.s), r = hn::Set(d, keys.r), one = hn::Set(d, 1.0f);
  for_each_joint_place(block, out, [&](const auto& place) HWY_ATTR {
    const auto numbers = unpack<4>(block, keys, place.lane());
    const QuatLanes q0 = rotation(block, numbers.begin, place.lane()), q1 = rotation(block, numbers.end, place.lane());
    const Lanes dot =
        hn::Add(hn::Add(hn::Mul(q0.x, q1.x), hn::Mul(q0.y, q1.y)), hn::Add(hn::Mul(q0.z, q1.z), hn::Mul(q0.w, q1.w)));
    const Lanes side = hn::IfThenElse(hn::Lt(dot, hn::Zero(d)), hn::Set(d, -1.0f), one);
    const auto apart = [&](Lanes a, Lanes b) HWY_ATTR { return hn::Sub(hn::Mul(b, side), a); };
    const Lanes quarter =
        hn::Mul(hn::Set(d, 0.25f), dot4(apart(q0.x, q1.x), apart(q0.y, q1.y), apart(q0.z, q1.z), apart(q0.w, q1.w)));
    const Lanes ratio = arc_ratio(quarter),
                squared = hn::Mul(hn::Mul(hn::Set(d, 4.0f), quarter), hn::Mul(ratio, ratio));
    const Lanes w0 = hn::Mul(r, sine_ratio(hn::Mul(hn::Mul(r, r), squared)));
    const Lanes w1 = hn::Mul(hn::Mul(s, side), sine_ratio(hn::Mul(hn::Mul(s, s), squared)));
    const auto mixed = [&](Lanes a, Lanes b) HWY_ATTR { return flushed(hn::Add(hn::Mul(a, w0), hn::Mul(b, w1))); };
    const Lanes x = mixed(q0.x, q1.x), y = mixed(q0.y, q1.y), z = mixed(q0.z, q1.z), w = mixed(q0.w, q1.w);
    const Lanes scale = hn::Div(one, hn::Sqrt(dot4(x, y, z, w)));
    place.store(0, hn::Mul(x, scale));
    place.store(1, hn::Mul(y, scale));
    place.store(2, hn::Mul(z, scale));
    place.store(3, hn::Mul(w, scale));
  });
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
