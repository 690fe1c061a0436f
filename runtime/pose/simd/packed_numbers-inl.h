// SPDX-License-Identifier: MIT
// Reads the numbers of packed keys (PackedRows). Included once per SIMD target, so without `#pragma once`. Rows are
// little-endian.
#if defined(SINEW_PACKED_NUMBERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_PACKED_NUMBERS_INL_H
#undef SINEW_PACKED_NUMBERS_INL_H
#else
#define SINEW_PACKED_NUMBERS_INL_H
#endif

#include "runtime/pose/simd/track_places-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

template <class D>
using MaskTag = hn::RebindToUnsigned<D>;
template <class D>
using Masks = hn::Vec<MaskTag<D>>;

#if HWY_TARGET == HWY_SCALAR

template <class D>
using RowBytes = const std::uint8_t*;
template <class D>
using Shuffle = std::uint8_t;

/// Loads sixteen bytes of a row for every four lanes.
template <class D>
HWY_INLINE RowBytes<D> load_fours(D, const std::uint8_t* row, const std::uint16_t* first_byte) {
  return row + *first_byte;
}
/// A shuffle that moves the four bytes from `byte` on into each lane.
template <class D>
HWY_INLINE Shuffle<D> shuffle_of(D, const std::uint8_t* byte) {
  return *byte;
}
template <class D>
HWY_INLINE Masks<D> shuffled(D, RowBytes<D> row, Shuffle<D> shuffle) {
  std::uint32_t bytes;
  hwy::CopyBytes<sizeof(bytes)>(row + shuffle, &bytes);
  return hn::Set(MaskTag<D>(), bytes);
}

#else

template <class D>
using ByteTag = hn::Repartition<std::uint8_t, D>;
template <class D>
using RowBytes = hn::Vec<ByteTag<D>>;
template <class D>
using Shuffle = hn::Vec<ByteTag<D>>;

template <class D>
HWY_INLINE hn::Vec<D> load_sixteens(D d, const std::uint8_t* row, const std::uint16_t* first_byte) {
  if constexpr (hn::MaxLanes(d) <= 16) {
    return hn::LoadU(d, row + *first_byte);
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, load_sixteens(half, row, first_byte + hn::MaxLanes(half) / 16),
                       load_sixteens(half, row, first_byte));
  }
}

/// Sixteen bytes of a row for each four lanes.
template <class D>
HWY_INLINE RowBytes<D> load_fours(D, const std::uint8_t* row, const std::uint16_t* first_byte) {
  return load_sixteens(ByteTag<D>(), row, first_byte);
}

/// Puts the four bytes from `byte` on into each lane.
template <class D>
HWY_INLINE Shuffle<D> shuffle_of(D, const std::uint8_t* byte) {
  HWY_ALIGN static constexpr std::uint8_t kFirst[16] = {0, 0, 0, 0, 4, 4, 4, 4, 8, 8, 8, 8, 12, 12, 12, 12};
  HWY_ALIGN static constexpr std::uint8_t kNext[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
  const ByteTag<D> d;
  const auto of_lanes = hn::PromoteTo(MaskTag<D>(), hn::LoadU(hn::Rebind<std::uint8_t, D>(), byte));
  return hn::Add(hn::TableLookupBytes(hn::BitCast(d, of_lanes), hn::LoadDup128(d, kFirst)), hn::LoadDup128(d, kNext));
}

template <class D>
HWY_INLINE Masks<D> shuffled(D, RowBytes<D> bytes, Shuffle<D> shuffle) {
  return hn::BitCast(MaskTag<D>(), hn::TableLookupBytes(bytes, shuffle));
}

#endif

/// The bytes of both keys that contain the numbers of a slot.
template <class D>
struct KeyBytes {
  RowBytes<D> begin, end;
};

template <class D>
HWY_INLINE KeyBytes<D> key_bytes(D d, const TrackBlock& block, const PackedKeys& keys, std::size_t slot,
                                 std::size_t lane) {
  const std::uint16_t* first_byte =
      block.packed.first_byte.data() + slot * ((std::size_t{block.lane_count} + 3) / 4) + lane / 4;
  return {load_fours(d, keys.begin, first_byte), load_fours(d, keys.end, first_byte)};
}

/// Where the lanes of one slot find their numbers in these bytes, and the range that the numbers map to.
template <class D>
class Slot {
 public:
  HWY_INLINE Slot(const TrackBlock& block, std::size_t slot, std::size_t lane) {
    const std::size_t at = slot * block.lane_count + lane;
    const PackedRows& rows = block.packed;
    const D d;
    shuffle_ = shuffle_of(d, rows.byte.data() + at);
    mask_ = hn::LoadU(MaskTag<D>(), rows.mask.data() + at);
    const auto upper = hn::PromoteTo(MaskTag<D>(), hn::LoadU(hn::Rebind<std::uint16_t, D>(), rows.step.data() + at));
    step_ = hn::BitCast(d, hn::ShiftLeft<16>(upper));
    low_ = hn::LoadU(d, rows.low.data() + at);
  }

  /// The number of a key, not shifted down to its lowest bit: below 2^31.
  HWY_INLINE hn::Vec<D> number(RowBytes<D> bytes) const {
    const D d;
    const hn::RebindToSigned<D> whole;
    return hn::ConvertTo(d, hn::BitCast(whole, hn::And(shuffled(d, bytes, shuffle_), mask_)));
  }
  /// eq   number * step + low
  HWY_INLINE hn::Vec<D> value(hn::Vec<D> number) const { return hn::Add(hn::Mul(number, step_), low_); }

 private:
  Shuffle<D> shuffle_;
  Masks<D> mask_;
  hn::Vec<D> step_, low_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
