// SPDX-License-Identifier: MIT
// Weights for blending the dual quaternions of one vertex, with the signs that align them to one hemisphere. Without
// the signs, q and -q of the same rotation would cancel.
#if defined(SINEW_HEMISPHERE_WEIGHTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_HEMISPHERE_WEIGHTS_INL_H_
#undef SINEW_HEMISPHERE_WEIGHTS_INL_H_
#else
#define SINEW_HEMISPHERE_WEIGHTS_INL_H_
#endif

#include <algorithm>
#include <cstddef>
#include <span>

#include "runtime/deform/simd/float8_lanes-inl.h"
#include "runtime/pose/joint_palette.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Real part of the pivot, which is the vertex's first influence. Other rotations are aligned to its hemisphere.
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

  /// The weight, negated if the dot product (x + y) + (z + w) with the pivot is negative.
  HWY_INLINE hn::Vec<Float8Tag> signed_weight(const float* real, float weight) const {
    const Float8Tag d;
    const auto products = hn::Mul(real_, hn::LoadDup128(d, real));
    const auto pairs = hn::Add(products, hn::Shuffle2301(products));
    const auto dot = hn::Add(hn::Add(pairs, hn::Shuffle1032(pairs)),
                             hn::Zero(d));  // adding 0 turns -0 into +0, so that it counts as positive
    return hn::Xor(hn::Set(d, weight), hn::And(dot, hn::SignBit(d)));
  }

 private:
  hn::Vec<Float8Tag> real_;
#endif
};

/// True if both rotations of every pair are in one hemisphere. Signs then need not be compared per vertex. The dot
/// products must exceed a small positive limit, so that the result does not depend on the order of summation. False for
/// an empty list, which means that the pairs are not known.
HWY_INLINE bool are_in_one_hemisphere(std::span<const JointPair> pairs, std::span<const RigidStretch> split) {
  constexpr float kClearlyPositive = 1e-5f;
#if HWY_TARGET == HWY_SCALAR
  const auto is_positive = [&](const JointPair& pair) {
    return quat_dot(split[pair.first].rigid.real, split[pair.second].rigid.real) > kClearlyPositive;
  };
  return !pairs.empty() && std::all_of(pairs.begin(), pairs.end(), is_positive);
#else
  const hn::FixedTag<float, 4> d;
  auto positive = hn::FirstN(d, 4);
  for (const JointPair& pair : pairs) {
    const auto products =
        hn::Mul(hn::Load(d, &split[pair.first].rigid.real.x), hn::Load(d, &split[pair.second].rigid.real.x));
    const auto halves = hn::Add(products, hn::Shuffle2301(products));
    const auto dot = hn::Add(halves, hn::Shuffle1032(halves));
    positive = hn::And(positive, hn::Gt(dot, hn::Set(d, kClearlyPositive)));
  }
  return !pairs.empty() && hn::AllTrue(d, positive);
#endif
}

/// Weights of one vertex: of(i) has weight i in all lanes. With kCount = 4, one load reads all four weights; with other
/// counts each weight is loaded on its own.
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
