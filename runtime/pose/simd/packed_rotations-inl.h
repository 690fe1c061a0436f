// SPDX-License-Identifier: MIT
// Reads packed rotations, which leave out one component. Included once per SIMD target, so without `#pragma once`.
#if defined(SINEW_PACKED_ROTATIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_PACKED_ROTATIONS_INL_H
#undef SINEW_PACKED_ROTATIONS_INL_H
#else
#define SINEW_PACKED_ROTATIONS_INL_H
#endif

#include "runtime/pose/simd/packed_numbers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Four components of a vector of rotations, in slot order.
template <class V>
struct QuatLanes {
  V a, b, c, derived;
};

template <class V>
HWY_INLINE V dot4(const QuatLanes<V>& p, const QuatLanes<V>& q) {
  return hn::Add(hn::Add(hn::Mul(p.a, q.a), hn::Mul(p.b, q.b)),
                 hn::Add(hn::Mul(p.c, q.c), hn::Mul(p.derived, q.derived)));
}

/// eq   sqrt(1 - a^2 - b^2 - c^2): the left-out component
template <class D, class V = hn::Vec<D>>
HWY_INLINE V derived_from(D d, V a, V b, V c) {
  const V sum = hn::Add(hn::Add(hn::Mul(a, a), hn::Mul(b, b)), hn::Mul(c, c));
  return hn::Sqrt(hn::Max(hn::Sub(hn::Set(d, 1.0f), sum), hn::Zero(d)));
}

/// A vector of rotations at both packed keys.
template <class D>
struct RotationPair {
  using V = hn::Vec<D>;
  QuatLanes<V> begin, end;

  HWY_INLINE RotationPair(const TrackBlock& block, const PackedKeys& keys, std::size_t lane) {
    const D d;
    KeyBytes<D> bytes = key_bytes(d, block, keys, 0, lane);
    const auto read = [&](std::size_t slot_index, V& of_begin, V& of_end) HWY_ATTR {
      const Slot<D> slot(block, slot_index, lane);
      of_begin = slot.value(slot.number(bytes.begin));
      of_end = slot.value(slot.number(bytes.end));
    };
    read(0, begin.a, end.a);
    if (!block.packed.shares_bytes[1]) bytes = key_bytes(d, block, keys, 1, lane);
    read(1, begin.b, end.b);
    if (!block.packed.shares_bytes[2]) bytes = key_bytes(d, block, keys, 2, lane);
    read(2, begin.c, end.c);
    begin.derived = derived_from(d, begin.a, begin.b, begin.c);
    end.derived = derived_from(d, end.a, end.b, end.c);
  }
};

/// Lanes whose left-out component is `component`.
template <class D>
HWY_INLINE auto leaves_out(D d, const PackedRows& rows, std::size_t lane, std::int32_t component) {
  const hn::RebindToSigned<D> whole;
  const auto derived = hn::PromoteTo(whole, hn::LoadU(hn::Rebind<std::uint8_t, D>(), rows.derived.data() + lane));
  return hn::RebindMask(d, hn::Eq(derived, hn::Set(whole, component)));
}

/// Reads the fourth component of tracks that leave none out; it is in slot 3.
template <class D>
HWY_INLINE void read_all(D d, const TrackBlock& block, const PackedKeys& keys, std::size_t lane,
                         RotationPair<D>& pair) {
  const auto all = leaves_out(d, block.packed, lane, PackedTrack::kNoneDerived);
  const Slot<D> slot(block, 3, lane);
  const KeyBytes<D> bytes = key_bytes(d, block, keys, 3, lane);
  pair.begin.derived = hn::IfThenElse(all, slot.value(slot.number(bytes.begin)), pair.begin.derived);
  pair.end.derived = hn::IfThenElse(all, slot.value(slot.number(bytes.end)), pair.end.derived);
}

/// Normalises the tracks that leave out no component. The others are unit already, because the fourth is derived.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void normalise_all(D d, const PackedRows& rows, std::size_t lane, QuatLanes<V>& q) {
  const V one = hn::Set(d, 1.0f);
  const auto all = leaves_out(d, rows, lane, PackedTrack::kNoneDerived);
  const V scale = hn::IfThenElse(all, hn::Div(one, hn::Sqrt(dot4(q, q))), one);
  q = {hn::Mul(q.a, scale), hn::Mul(q.b, scale), hn::Mul(q.c, scale), hn::Mul(q.derived, scale)};
}

/// Reorders the components from slot order to x y z w.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void swap_back(D d, const PackedRows& rows, std::size_t lane, QuatLanes<V>& q) {
  const auto x = leaves_out(d, rows, lane, 0), y = leaves_out(d, rows, lane, 1), z = leaves_out(d, rows, lane, 2);
  const V w = hn::IfThenElse(z, q.c, q.derived);
  const QuatLanes<V> swapped{hn::IfThenElse(x, q.derived, q.a), hn::IfThenElse(y, q.derived, q.b),
                             hn::IfThenElse(z, q.derived, q.c), hn::IfThenElse(x, q.a, hn::IfThenElse(y, q.b, w))};
  q = swapped;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
