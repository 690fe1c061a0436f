// SPDX-License-Identifier: MIT
// Blended dual quaternions and stretches of a tile, kept in memory. Blending waits for loads, the rest for arithmetic,
// and processors do not look far enough ahead to overlap the two. So several tiles are blended before the rest is done.
#if defined(SINEW_KEPT_SPLITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_KEPT_SPLITS_INL_H_
#undef SINEW_KEPT_SPLITS_INL_H_
#else
#define SINEW_KEPT_SPLITS_INL_H_
#endif

#include "runtime/deform/simd/blend_dual_quaternions-inl.h"
#include "runtime/deform/simd/blend_stretch_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Blends of one tile: dual quaternions, and stretches if any joint stretches.
template <bool kStretch>
class KeptSplits {
 public:
  /// in   one_hemisphere  all rotations are in one hemisphere: dual quaternion and stretch are then blended as one
  template <int kCount>
  HWY_INLINE void keep(const RigidStretch* split, const TileInfluences<kCount>& tile, bool one_hemisphere) {
    if constexpr (kStretch) {
      if (kCount != 1 && one_hemisphere) return keep_whole(split, tile);
      for_each_of_tile([&](std::size_t k)
                           HWY_ATTR { store_float8(blend_stretch_float8(split, tile, k), floats_[k] + 8); });
    }
    for_each_dual_quaternion(split, tile, one_hemisphere,
                             [&](std::size_t k, const Float8& sum) HWY_ATTR { store_float8(sum, floats_[k]); });
  }

  HWY_INLINE DualQuatLanes motion() const { return dual_quat_lanes(lanes_from(0)); }
  HWY_INLINE StretchLanes stretch() const {
    static_assert(kStretch);
    return stretch_lanes(lanes_from(8));
  }

 private:
  static constexpr std::size_t kFloats = kStretch ? 16 : 8, kParts = 16 / kTileSize;
  HWY_ALIGN float floats_[kTileSize][kFloats];

  /// Blends dual quaternion and stretch in one loop, because they share addresses and weights.
  template <int kCount>
  HWY_INLINE void keep_whole(const RigidStretch* split, const TileInfluences<kCount>& tile) {
    const TileTag d;
    for_each_of_tile([&](std::size_t k) HWY_ATTR {
      const VertexJoints<kCount> vertex = tile.at(k);
      const auto entry = [&](std::size_t i) HWY_ATTR { return &tile.entry(split, k, i)->rigid.real.x; };
      Wide sum[kParts];
      const float* first = entry(0);
      const Wide weight = hn::Set(d, vertex.weights[0]);
      for (std::size_t p = 0; p < kParts; ++p) sum[p] = hn::Mul(hn::Load(d, first + p * kTileSize), weight);
      for (std::size_t i = 1; i < vertex.count(); ++i) {
        const float* next = entry(i);
        const Wide w = hn::Set(d, vertex.weights[i]);
        for (std::size_t p = 0; p < kParts; ++p) sum[p] = hn::MulAdd(hn::Load(d, next + p * kTileSize), w, sum[p]);
      }
      for (std::size_t p = 0; p < kParts; ++p) hn::Store(sum[p], d, floats_[k] + p * kTileSize);
    });
  }
  HWY_INLINE Lanes8 lanes_from(std::size_t first) const {
    Float8 sums[kTileSize];
    for (std::size_t k = 0; k < kTileSize; ++k) sums[k] = load_float8(floats_[k] + first);
    return lanes_of(sums);
  }
};

/// Number of tiles that are blended ahead.
constexpr std::size_t kTilesAhead = 8;

/// Blends the tiles [first, end) of a row. Only this stage depends on the number of influences.
template <bool kStretch>
using KeepSplits = void(const RigidStretch* split, const TileRow<0>& row, std::size_t first, std::size_t end,
                        bool one_hemisphere, KeptSplits<kStretch>* kept);

/// The function for groups of `influence_count` influences. Compiled once, in skin_dual_quaternion.cpp.
template <bool kStretch>
KeepSplits<kStretch>* keep_splits_of(std::uint32_t influence_count);
template <>
KeepSplits<false>* keep_splits_of<false>(std::uint32_t influence_count);
template <>
KeepSplits<true>* keep_splits_of<true>(std::uint32_t influence_count);

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
