// SPDX-License-Identifier: MIT
// Four by four transposition. Included once per SIMD target, so without `#pragma once`.
#if defined(SINEW_TRANSPOSE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TRANSPOSE_INL_H
#undef SINEW_TRANSPOSE_INL_H
#else
#define SINEW_TRANSPOSE_INL_H
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct FourVectors {
  V x, y, z, w;
};

#if HWY_TARGET != HWY_SCALAR

/// Transposes four by four within every 128-bit block: lane i of the results comes from argument i. Self-inverse.
template <class D, class V = hn::Vec<D>>
HWY_INLINE FourVectors<V> transpose_blocks(D d, V a, V b, V c, V e) {
  const V ac_low = hn::InterleaveLower(d, a, c), ac_high = hn::InterleaveUpper(d, a, c);
  const V be_low = hn::InterleaveLower(d, b, e), be_high = hn::InterleaveUpper(d, b, e);
  return {hn::InterleaveLower(d, ac_low, be_low), hn::InterleaveUpper(d, ac_low, be_low),
          hn::InterleaveLower(d, ac_high, be_high), hn::InterleaveUpper(d, ac_high, be_high)};
}

#endif  // HWY_TARGET

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
