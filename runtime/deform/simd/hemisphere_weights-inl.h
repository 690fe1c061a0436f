// SPDX-License-Identifier: MIT
// Weights for blending the dual quaternions of one vertex, with the signs that align them to one hemisphere (N17).
#if defined(SINEW_HEMISPHERE_WEIGHTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_HEMISPHERE_WEIGHTS_INL_H_
#undef SINEW_HEMISPHERE_WEIGHTS_INL_H_
#else
#define SINEW_HEMISPHERE_WEIGHTS_INL_H_
#endif

#include <cstddef>

#include "runtime/deform/simd/float8_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Real part of the pivot in every block, to find the hemisphere of other rotations.
class Pivot {
 public:
#if HWY_TARGET == HWY_SCALAR
  explicit Pivot(const float* real) : real_(real) {}

  hn::Vec<Float8Tag> signed_weight(const float* real, float weight) const {
    const float dot = (real_[0] * real[0] + real_[1] * real[1]) + (real_[2] * real[2] + real_[3] * real[3]);
    return hn::Set(Float8Tag(), dot < 0.0f ? -weight : weight);
  }

 private:
  const float* real_;
#else
  HWY_INLINE explicit Pivot(const float* real) : real_(hn::LoadDup128(Float8Tag(), real)) {}

  /// The weight, negated where the dot product (x + y) + (z + w) with the pivot is less than zero.
  HWY_INLINE hn::Vec<Float8Tag> signed_weight(const float* real, float weight) const {
    const Float8Tag d;
    const auto products = hn::Mul(real_, hn::LoadDup128(d, real));
    const auto pairs = hn::Add(products, hn::Shuffle2301(products));
    const auto dot = hn::Add(hn::Add(pairs, hn::Shuffle1032(pairs)), hn::Zero(d));  // + 0: -0 is not less than zero
    return hn::Xor(hn::Set(d, weight), hn::And(dot, hn::SignBit(d)));
  }

 private:
  hn::Vec<Float8Tag> real_;
#endif
};

/// Weights of one vertex, each in all lanes. Four are loaded at once.
template <int kCount>
class Float8Weights {
 public:
  HWY_INLINE explicit Float8Weights(const float* weights) : weights_(weights) {}
  HWY_INLINE hn::Vec<Float8Tag> of(std::size_t i) const { return hn::Set(Float8Tag(), weights_[i]); }

 private:
  const float* weights_;
};

#if HWY_TARGET != HWY_SCALAR
template <>
class Float8Weights<4> {
 public:
  HWY_INLINE explicit Float8Weights(const float* weights) : four_(hn::LoadDup128(Float8Tag(), weights)) {}
  HWY_INLINE hn::Vec<Float8Tag> of(std::size_t i) const {
    switch (i) {
      case 0: return hn::Broadcast<0>(four_);
      case 1: return hn::Broadcast<1>(four_);
      case 2: return hn::Broadcast<2>(four_);
      default: return hn::Broadcast<3>(four_);
    }
  }

 private:
  hn::Vec<Float8Tag> four_;
};
#endif

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
