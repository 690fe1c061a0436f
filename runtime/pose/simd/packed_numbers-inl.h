// SPDX-License-Identifier: MIT
// Unpacks the integers of packed keys; included once per SIMD target, so without `#pragma once`. Rows are
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

using WholeTag = hn::RebindToSigned<Floats>;
using Whole = hn::Vec<WholeTag>;

/// Integers of the components of some lanes at both keys.
template <std::size_t kComponents>
struct Numbers {
  Whole begin[kComponents], end[kComponents];
};

#if HWY_TARGET == HWY_SCALAR

/// Unpacks one lane of the rows of two keys.
template <std::size_t kComponents>
HWY_INLINE Numbers<kComponents> unpack(const TrackBlock& block, const PackedKeys& keys, std::size_t lane) {
  const std::uint32_t first_bit = block.packed.first_bit[lane];
  std::uint64_t b, e;
  hwy::CopyBytes<sizeof(b)>(keys.begin + first_bit / 8, &b);
  hwy::CopyBytes<sizeof(e)>(keys.end + first_bit / 8, &e);
  b >>= first_bit % 8;
  e >>= first_bit % 8;
  Numbers<kComponents> out;
  for (std::size_t c = 0; c < kComponents; ++c) {
    const std::uint32_t width = block.packed.width[c * block.lane_count + lane];
    const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
    out.begin[c] = hn::Set(WholeTag(), static_cast<std::int32_t>(b & mask));
    out.end[c] = hn::Set(WholeTag(), static_cast<std::int32_t>(e & mask));
    b >>= width;
    e >>= width;
  }
  return out;
}

#else

using WordTag = hn::Repartition<std::uint64_t, Floats>;
using Words = hn::Vec<WordTag>;

/// 64-bit integers of the even lanes and of the odd lanes.
struct WordPairs {
  Words even, odd;
};

HWY_INLINE WordPairs widened(Whole of_lanes) {
  const WordTag d;
  const Words pairs = hn::BitCast(d, of_lanes);
  return {hn::And(pairs, hn::Set(d, 0xffffffffu)), hn::ShiftRight<32>(pairs)};
}

/// Eight bytes of a row for every lane.
HWY_INLINE WordPairs gather(const std::uint8_t* row, const WordPairs& first_byte) {
  const WordTag d;
  const hn::RebindToSigned<WordTag> offsets;
  const auto* words = reinterpret_cast<const std::uint64_t*>(row);
  return {hn::GatherOffset(d, words, hn::BitCast(offsets, first_byte.even)),
          hn::GatherOffset(d, words, hn::BitCast(offsets, first_byte.odd))};
}

/// The integers that begin at bit `shift` of each word.
HWY_INLINE Whole numbers_at(const WordPairs& words, const WordPairs& shift, Whole mask) {
  const WholeTag whole;
  const Words even = hn::Shr(words.even, shift.even), odd = hn::Shr(words.odd, shift.odd);
  return hn::And(hn::OddEven(hn::BitCast(whole, hn::ShiftLeft<32>(odd)), hn::BitCast(whole, even)), mask);
}

/// Unpacks a vector of lanes from `lane` on of the rows of two keys. Lanes past the last track read bits of the first.
template <std::size_t kComponents>
HWY_INLINE Numbers<kComponents> unpack(const TrackBlock& block, const PackedKeys& keys, std::size_t lane) {
  const WholeTag whole;
  const Whole one = hn::Set(whole, 1);
  const Whole first_bit =
      hn::PromoteTo(whole, hn::LoadU(hn::Rebind<std::uint16_t, Floats>(), block.packed.first_bit.data() + lane));
  const WordPairs first_byte = widened(hn::ShiftRight<3>(first_bit));
  const WordPairs begin = gather(keys.begin, first_byte), end = gather(keys.end, first_byte);
  Whole shift = hn::And(first_bit, hn::Set(whole, 7));
  Numbers<kComponents> out;
  for (std::size_t c = 0; c < kComponents; ++c) {
    const Whole width = hn::PromoteTo(
        whole, hn::LoadU(hn::Rebind<std::uint8_t, Floats>(), block.packed.width.data() + c * block.lane_count + lane));
    const Whole mask = hn::Sub(hn::Shl(one, width), one);
    const WordPairs shifts = widened(shift);
    out.begin[c] = numbers_at(begin, shifts, mask);
    out.end[c] = numbers_at(end, shifts, mask);
    shift = hn::Add(shift, width);
  }
  return out;
}

#endif

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
