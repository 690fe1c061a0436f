// SPDX-License-Identifier: MIT
// Dual quaternions and stretches that all vertices of a tile share (shared_joints-inl.h), blended with one vertex per
// lane. The operations are those of blend_dual_quaternions-inl.h in the same order, so results have the same bits.
// Hemisphere signs depend on joints alone, so they are computed once per tile.
#if defined(SINEW_SHARED_SPLITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SHARED_SPLITS_INL_H_
#undef SINEW_SHARED_SPLITS_INL_H_
#else
#define SINEW_SHARED_SPLITS_INL_H_
#endif

#include "runtime/deform/simd/hemisphere_weights-inl.h"
#include "runtime/deform/simd/shared_joints-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

template <int kCount>
class SharedSplits {
 public:
  /// in   one_hemisphere  all rotations are known to be in one hemisphere, so no sign is compared
  HWY_INLINE SharedSplits(const RigidStretch* split, const std::uint16_t* joints, bool one_hemisphere) {
    for (std::size_t i = 0; i < kCount; ++i) {
      entry_[i] = &split[joints[i]].rigid.real.x;
      sign_[i] = i == 0 || one_hemisphere ? 0.0f : sign_of(entry_[0], entry_[i]);
    }
  }

  /// Writes eight vectors of kTileSize floats.
  /// eq   sum(w sign(r . r_pivot) d_i)
  HWY_INLINE void blend_dual_quaternions(const WeightLanes<kCount>& weights, float* to) const {
    WeightLanes<kCount> w = weights;
    for (std::size_t i = 1; i < kCount; ++i) w.of[i] = hn::Xor(w.of[i], hn::Set(TileTag(), sign_[i]));
    blend<0, 8>(w, to);
  }
  /// Writes the six entries of the stretch as vectors of kTileSize floats.
  /// eq   sum(w S_i)
  HWY_INLINE void blend_stretches(const WeightLanes<kCount>& weights, float* to) const { blend<8, 6>(weights, to); }

 private:
  static HWY_INLINE float sign_of(const float* a, const float* b) {
    return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]) < 0.0f ? -0.0f : 0.0f;
  }

  template <std::size_t kFirst, std::size_t kFloats>
  HWY_INLINE void blend(const WeightLanes<kCount>& weights, float* to) const {
    const TileTag d;
    for (std::size_t f = 0; f < kFloats; ++f) {
      Wide sum = hn::Mul(hn::Set(d, entry_[0][kFirst + f]), weights.of[0]);
      for (std::size_t i = 1; i < kCount; ++i) sum = hn::MulAdd(hn::Set(d, entry_[i][kFirst + f]), weights.of[i], sum);
      hn::Store(sum, d, to + f * kTileSize);
    }
  }

  const float* entry_[kCount];
  float sign_[kCount];  ///< +0 or -0: the sign bit is applied to the weight
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
