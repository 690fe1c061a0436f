// SPDX-License-Identifier: MIT
// Interpolation of blocks of packed tracks, one track per lane. Included once per SIMD target, so without
// `#pragma once`. Multiplications and additions are never fused, so all targets give the same bits.
#if defined(SINEW_PACKED_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_PACKED_LANES_INL_H
#undef SINEW_PACKED_LANES_INL_H
#else
#define SINEW_PACKED_LANES_INL_H
#endif

#include "runtime/clip/slerp_series.h"
#include "runtime/pose/simd/packed_places-inl.h"
#include "runtime/pose/simd/packed_rotations-inl.h"
#include "runtime/pose/simd/track_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// eq   (1 - s) v0 + s v1, on the packed integers: both keys share one range, which is applied to the result
template <std::size_t kComponents>
HWY_INLINE void lerp_components(const TrackBlock& block, const PackedKeys& keys, const TrackOutput& out) {
  for_each_lane<kComponents>(block, out, [&](auto d, std::size_t lane, float* to, std::size_t stride) HWY_ATTR {
    const auto s = hn::Set(d, keys.s), r = hn::Set(d, keys.r);
    auto bytes = key_bytes(d, block, keys, 0, lane);
    for (std::size_t c = 0; c < kComponents; ++c) {
      if (c > 0 && !block.packed.shares_bytes[c]) bytes = key_bytes(d, block, keys, c, lane);
      const Slot<decltype(d)> slot(block, c, lane);
      const auto number = hn::Add(hn::Mul(slot.number(bytes.begin), r), hn::Mul(slot.number(bytes.end), s));
      hn::StoreU(slot.value(number), d, to + c * stride);
    }
  });
}

HWY_NOINLINE void lerp_packed(const TrackBlock& block, const PackedKeys& keys, const TrackOutput& out) {
  if (component_count(block.property) == 3)
    lerp_components<3>(block, keys, out);
  else
    lerp_components<1>(block, keys, out);
}

/// The slerp series of both keys. Each coefficient is repeated in a whole vector.
class SlerpSeries {
 public:
  HWY_INLINE explicit SlerpSeries(const PackedKeys& keys) : power_(keys.power) {
    const SlerpCoefficients coefficients(keys.r, keys.s, power_);
    const auto keep = [&](std::size_t i) HWY_ATTR {
      const Floats d;
      hn::Store(hn::Set(d, coefficients.of_power[i].begin), d, begin_ + i * kLanes);
      hn::Store(hn::Set(d, coefficients.of_power[i].end), d, end_ + i * kLanes);
    };
    for (std::size_t i = 0; i <= kUsualSlerpPower; ++i) keep(i);
    for (std::size_t i = kUsualSlerpPower + 1; i <= power_; ++i) keep(i);
  }

  template <class D, class V = hn::Vec<D>>
  HWY_INLINE void weights(D d, V x, V& begin, V& end) const {
    begin = hn::Load(d, begin_ + power_ * kLanes);
    end = hn::Load(d, end_ + power_ * kLanes);
    const auto next = [&](std::size_t i) HWY_ATTR {
      begin = hn::Add(hn::Mul(begin, x), hn::Load(d, begin_ + i * kLanes));
      end = hn::Add(hn::Mul(end, x), hn::Load(d, end_ + i * kLanes));
    };
    for (std::size_t i = power_; HWY_UNLIKELY(i-- > kUsualSlerpPower);) next(i);
    for (std::size_t i = kUsualSlerpPower; i-- > 0;) next(i);
  }

 private:
  static constexpr std::size_t kLanes = hn::MaxLanes(Floats());
  HWY_ALIGN float begin_[(kMostSlerpPower + 1) * kLanes];
  HWY_ALIGN float end_[(kMostSlerpPower + 1) * kLanes];
  std::size_t power_;
};

/// Slerp of packed keys along the shorter arc, whatever their signs. Only tracks that store all four components are
/// normalised: rounding makes their keys not quite unit.
/// eq   q0 sin(r a) / sin(a) + q1 sin(s a) / sin(a), by slerp_series.h: nearly equal keys keep their relative accuracy
HWY_NOINLINE void slerp_packed(const TrackBlock& block, const PackedKeys& keys, const TrackOutput& out) {
  const SlerpSeries series(keys);
  const PackedRows& rows = block.packed;
  for_each_lane<4>(block, out, [&](auto d, std::size_t lane, float* to, std::size_t stride) HWY_ATTR {
    using V = hn::Vec<decltype(d)>;
    const unsigned kinds = rows.kinds[lane / kLanePadding];
    RotationPair<decltype(d)> pair(block, keys, lane);
    if ((kinds & PackedRows::no_derived) != 0) read_all(d, block, keys, lane, pair);
    const QuatLanes<V>&q0 = pair.begin, &q1 = pair.end;
    const V dot = dot4(q0, q1);
    V w0, w1;
    series.weights(d, hn::Sub(hn::Set(d, 1.0f), hn::Abs(dot)), w0, w1);
    w1 = hn::Xor(w1, hn::And(dot, hn::Set(d, -0.0f)));
    const auto mixed = [&](V a, V b) HWY_ATTR { return hn::Add(hn::Mul(a, w0), hn::Mul(b, w1)); };
    QuatLanes<V> q{mixed(q0.a, q1.a), mixed(q0.b, q1.b), mixed(q0.c, q1.c), mixed(q0.derived, q1.derived)};
    if ((kinds & PackedRows::no_derived) != 0) normalise_all(d, rows, lane, q);
    if ((kinds & PackedRows::swapped) != 0) swap_back(d, rows, lane, q);
    hn::StoreU(q.a, d, to);
    hn::StoreU(q.b, d, to + stride);
    hn::StoreU(q.c, d, to + 2 * stride);
    hn::StoreU(q.derived, d, to + 3 * stride);
  });
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
