// SPDX-License-Identifier: MIT
// Blends the joint matrices of one vertex.
#if defined(SINEW_BLEND_MATRIX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_BLEND_MATRIX_INL_H_
#undef SINEW_BLEND_MATRIX_INL_H_
#else
#define SINEW_BLEND_MATRIX_INL_H_
#endif

#include "runtime/deform/simd/vertex_tiles-inl.h"
#include "runtime/math/joint_matrix.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// One matrix in as many vectors as it takes.
struct MatrixVectors {
  static constexpr std::size_t kCount = 16 / kTileSize;
  Wide part[kCount];
};

/// Weight `i` of vertex `k`, in all lanes. Loads four weights at once, because blending spends its time on loads.
template <int kCount>
HWY_INLINE Wide weight_of(const TileInfluences<kCount>& tile, std::size_t k, std::size_t i) {
  const TileTag d;
#if HWY_TARGET != HWY_SCALAR
  if constexpr (kCount > 1) {
    const std::size_t at = k * kCount + i;
    const Wide four = hn::LoadDup128(d, tile.first.weights + at / 4 * 4);
    switch (at % 4) {
      case 0: return hn::Broadcast<0>(four);
      case 1: return hn::Broadcast<1>(four);
      case 2: return hn::Broadcast<2>(four);
      default: return hn::Broadcast<3>(four);
    }
  }
#endif
  return hn::Set(d, tile.at(k).weights[i]);
}

/// Blended matrix of vertex `k`; fused from the second influence on. A vertex with one influence takes the joint's
/// matrix as it is.
/// eq   M = sum(w_i * palette[joint_i])
template <int kCount>
HWY_INLINE MatrixVectors blend_matrix_vectors(const JointMatrix* palette, const TileInfluences<kCount>& tile,
                                              std::size_t k) {
  const TileTag d;
  MatrixVectors sum;
  const float* joint = &tile.entry(palette, k, 0)->column[0].x;
  for (std::size_t p = 0; p < MatrixVectors::kCount; ++p) sum.part[p] = hn::Load(d, joint + p * kTileSize);
  if constexpr (kCount == 1) return sum;
  const Wide first = weight_of(tile, k, 0);
  for (Wide& part : sum.part) part = hn::Mul(part, first);
  for (std::size_t i = 1; i < tile.first.count(); ++i) {
    joint = &tile.entry(palette, k, i)->column[0].x;
    const Wide weight = weight_of(tile, k, i);
    for (std::size_t p = 0; p < MatrixVectors::kCount; ++p)
      sum.part[p] = hn::MulAdd(hn::Load(d, joint + p * kTileSize), weight, sum.part[p]);
  }
  return sum;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
