// SPDX-License-Identifier: MIT
// The weights with which the motions of one vertex are blended, each in all lanes, with the signs that rotations get.
#if defined(SINEW_MOTION_WEIGHTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_MOTION_WEIGHTS_INL_H_
#undef SINEW_MOTION_WEIGHTS_INL_H_
#else
#define SINEW_MOTION_WEIGHTS_INL_H_
#endif

#include <cstddef>

#include "runtime/deform/simd/eight_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// The pivot's real part in every block, to see on which side of it other rotations are (N17).
class Pivot {
 public:
#if HWY_TARGET == HWY_SCALAR
  explicit Pivot(const float* real) : real_(real) {}

  hn::Vec<EightTag> signed_weight(const float* real, float weight) const {
    const float dot = (real_[0] * real[0] + real_[1] * real[1]) + (real_[2] * real[2] + real_[3] * real[3]);
    return hn::Set(EightTag(), dot < 0.0f ? -weight : weight);
  }

 private:
  const float* real_;
#else
  HWY_INLINE explicit Pivot(const float* real) : real_(hn::LoadDup128(EightTag(), real)) {}

  /// -weight where the rotations are on opposite sides: the sum (x + y) + (z + w) of the products is less than zero.
  HWY_INLINE hn::Vec<EightTag> signed_weight(const float* real, float weight) const {
    const EightTag d;
    const auto products = hn::Mul(real_, hn::LoadDup128(d, real));
    const auto pairs = hn::Add(products, hn::Shuffle2301(products));
    const auto dot = hn::Add(hn::Add(pairs, hn::Shuffle1032(pairs)), hn::Zero(d));  // + 0: -0 is not less than zero
    return hn::Xor(hn::Set(d, weight), hn::And(dot, hn::SignBit(d)));
  }

 private:
  hn::Vec<EightTag> real_;
#endif
};

/// Weights of one vertex, each in all lanes. Four are loaded at once.
template <int kCount>
class EightWeights {
 public:
  HWY_INLINE explicit EightWeights(const float* weights) : weights_(weights) {}
  HWY_INLINE hn::Vec<EightTag> of(std::size_t i) const { return hn::Set(EightTag(), weights_[i]); }

 private:
  const float* weights_;
};

#if HWY_TARGET != HWY_SCALAR
template <>
class EightWeights<4> {
 public:
  HWY_INLINE explicit EightWeights(const float* weights) : four_(hn::LoadDup128(EightTag(), weights)) {}
  HWY_INLINE hn::Vec<EightTag> of(std::size_t i) const {
    switch (i) {
      case 0: return hn::Broadcast<0>(four_);
      case 1: return hn::Broadcast<1>(four_);
      case 2: return hn::Broadcast<2>(four_);
      default: return hn::Broadcast<3>(four_);
    }
  }

 private:
  hn::Vec<EightTag> four_;
};
#endif

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
