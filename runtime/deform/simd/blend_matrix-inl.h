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

/// One matrix, in as many vectors as it needs.
struct MatrixVectors {
  static constexpr std::size_t kCount = 16 / kTileSize;
  Wide part[kCount];
};

/// Addresses of a palette. Each half of a matrix has its own base address, so that every load is one instruction. With
/// one base, compilers add the offset of the joint first. Functions that loop over vertices get this as an argument and
/// are not inlined, or compilers would merge the bases.
struct PaletteBases {
  const JointMatrix* palette;
  const float* upper;

  explicit PaletteBases(const JointMatrix* all) : palette(all), upper(&all->column[2].x) {}
  HWY_INLINE Wide load(std::size_t offset, std::size_t part) const {
    const bool is_upper = MatrixVectors::kCount == 2 && part == 1;
    const void* base = is_upper ? static_cast<const void*>(upper) : palette;
    const std::size_t within = is_upper ? 0 : part * sizeof(Wide);
    return hn::Load(TileTag(), reinterpret_cast<const float*>(static_cast<const char*>(base) + offset + within));
  }
};

/// Weight `i` of vertex `k`, in all lanes. Loads four weights at once, because loads limit the speed of blending.
template <int kCount>
HWY_INLINE Wide weight_of(const TileInfluences<kCount>& tile, std::size_t k, std::size_t i) {
  const TileTag d;
#if HWY_TARGET != HWY_SCALAR
  if constexpr (kCount > 1) {
    const std::size_t at = k * kCount + i;
    const Wide four = hn::LoadDup128(d, tile.first.weights + at / 4 * 4);
    switch (at % 4) {
      case 0: return broadcast<0>(four);
      case 1: return broadcast<1>(four);
      case 2: return broadcast<2>(four);
      default: return broadcast<3>(four);
    }
  }
#endif
  return hn::Set(d, tile.at(k).weights[i]);
}

/// Blended matrix of vertex `k`; multiplications and additions are fused from the second influence on. A vertex with
/// one influence takes the joint's matrix as it is.
/// eq   M = sum(w_i * palette[joint_i])
template <int kCount>
HWY_INLINE MatrixVectors blend_matrix_vectors(const PaletteBases& palette, const TileInfluences<kCount>& tile,
                                              std::size_t k) {
  MatrixVectors sum;
  std::size_t joint = tile.template offset<sizeof(JointMatrix)>(k, 0);
  for (std::size_t p = 0; p < MatrixVectors::kCount; ++p) sum.part[p] = palette.load(joint, p);
  if constexpr (kCount == 1) return sum;
  const Wide first = weight_of(tile, k, 0);
  for (Wide& part : sum.part) part = hn::Mul(part, first);
  for (std::size_t i = 1; i < tile.first.count(); ++i) {
    joint = tile.template offset<sizeof(JointMatrix)>(k, i);
    const Wide weight = weight_of(tile, k, i);
    for (std::size_t p = 0; p < MatrixVectors::kCount; ++p)
      sum.part[p] = hn::MulAdd(palette.load(joint, p), weight, sum.part[p]);
  }
  return sum;
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
