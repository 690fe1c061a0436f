// SPDX-License-Identifier: MIT
// Blended joint matrices of a quarter tile (a fourth of the vertices in a vector). They are blended vertex by vertex
// and then transposed into columns.
#if defined(SINEW_BLEND_COLUMNS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_BLEND_COLUMNS_INL_H_
#undef SINEW_BLEND_COLUMNS_INL_H_
#else
#define SINEW_BLEND_COLUMNS_INL_H_
#endif

#include "runtime/deform/simd/blend_matrix-inl.h"
#include "runtime/deform/simd/quarter_lanes-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Matrices of a quarter tile, column by column. Each 128-bit block holds the column of one vertex.
struct Columns {
  Wide c0, c1, c2, c3;
};

HWY_INLINE Columns columns_of(const MatrixVectors (&m)[kBlocks]) {
#if HWY_MAX_BYTES >= 64
  const TileTag d;
  // Blocks are swapped before halves, because in the reverse order compilers extract the halves twice.
  const auto even = [](Wide a, Wide b) HWY_ATTR { return hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a); };
  const auto odd = [](Wide a, Wide b) HWY_ATTR { return hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a)); };
  const Wide even_01 = even(m[0].part[0], m[1].part[0]), even_23 = even(m[2].part[0], m[3].part[0]);
  const Wide odd_01 = odd(m[0].part[0], m[1].part[0]), odd_23 = odd(m[2].part[0], m[3].part[0]);
  return {hn::ConcatLowerLower(d, even_23, even_01), hn::ConcatLowerLower(d, odd_23, odd_01),
          hn::ConcatUpperUpper(d, even_23, even_01), hn::ConcatUpperUpper(d, odd_23, odd_01)};
#elif HWY_MAX_BYTES >= 32
  const TileTag d;
  return {hn::ConcatLowerLower(d, m[1].part[0], m[0].part[0]), hn::ConcatUpperUpper(d, m[1].part[0], m[0].part[0]),
          hn::ConcatLowerLower(d, m[1].part[1], m[0].part[1]), hn::ConcatUpperUpper(d, m[1].part[1], m[0].part[1])};
#else
  return {m[0].part[0], m[0].part[1], m[0].part[2], m[0].part[3]};
#endif
}

/// Blended matrices of one quarter tile. The loop must be unrolled, or compilers keep the matrices in memory.
template <int kCount>
HWY_INLINE Columns blend_columns(const PaletteBases& palette, const TileInfluences<kCount>& tile, std::size_t quarter) {
  MatrixVectors matrices[kBlocks];
#if HWY_COMPILER_GCC_ACTUAL
#pragma GCC unroll 4
#endif
  for (std::size_t b = 0; b < kBlocks; ++b) matrices[b] = blend_matrix_vectors(palette, tile, quarter * kBlocks + b);
  return columns_of(matrices);
}

HWY_INLINE Wide transform_points(const Columns& m, const Spread3& p) {
  return hn::MulAdd(m.c2, p.z, hn::MulAdd(m.c1, p.y, hn::MulAdd(m.c0, p.x, m.c3)));
}
HWY_INLINE Wide transform_vectors(const Columns& m, const Spread3& v) {
  return hn::MulAdd(m.c2, v.z, hn::MulAdd(m.c1, v.y, hn::Mul(m.c0, v.x)));
}

/// Rotates the components of every block: (x y z -) becomes (y z x -).
HWY_INLINE Wide next_components(Wide v) {
  static constexpr LaneTable kTable([](std::size_t i) { return i / 4 * 4 + (i % 4 == 3 ? 3 : (i + 1) % 4 % 3); });
  return hn::TableLookupLanes(v, hn::SetTableIndices(TileTag(), kTable.lanes));
}

HWY_INLINE Wide cross_blocks(Wide a, Wide next_a, Wide b, Wide next_b) {
  return next_components(hn::NegMulAdd(next_a, b, hn::Mul(a, next_b)));
}

/// Columns of the cofactor matrix: c1 x c2, c2 x c0, c0 x c1.
HWY_INLINE Columns cofactor(const Columns& m) {
  const Wide n0 = next_components(m.c0), n1 = next_components(m.c1), n2 = next_components(m.c2);
  return {cross_blocks(m.c1, n1, m.c2, n2), cross_blocks(m.c2, n2, m.c0, n0), cross_blocks(m.c0, n0, m.c1, n1), m.c3};
}

/// x + y + z of every block, in all lanes of the block.
HWY_INLINE Wide component_sums(Wide v) { return hn::Add(hn::Add(broadcast<0>(v), broadcast<1>(v)), broadcast<2>(v)); }

/// Moved normals, not normalised. A normal is zero where float cannot tell its side (OutwardSide); the scalar path then
/// computes it.
/// eq   M n, or sign(det M) cof(M) n
HWY_INLINE Wide moved_normals(const Columns& m, const Spread3& n, bool cofactor_rule) {
  if (!cofactor_rule) return transform_vectors(m, n);
  const Columns cof = cofactor(m);
  const Wide squares = component_sums(hn::MulAdd(m.c2, m.c2, hn::MulAdd(m.c1, m.c1, hn::Mul(m.c0, m.c0))));
  return OutwardSide(component_sums(hn::Mul(m.c0, cof.c0)), squares).turn(transform_vectors(cof, n));
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
