// SPDX-License-Identifier: MIT
// Blended matrices of the scalar target, whose tile is one vertex: the operations of blend_columns-inl.h in the same
// order.
#if defined(SINEW_SCALAR_MATRIX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SCALAR_MATRIX_INL_H_
#undef SINEW_SCALAR_MATRIX_INL_H_
#else
#define SINEW_SCALAR_MATRIX_INL_H_
#endif

#include "runtime/deform/simd/blend_matrix-inl.h"
#include "runtime/deform/simd/lane_memory-inl.h"

#if HWY_TARGET == HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

struct ScalarMatrix {
  Lanes3 c0, c1, c2, c3;
};

template <int kCount>
HWY_INLINE ScalarMatrix blend_scalar_matrix(const PaletteBases& palette, const TileInfluences<kCount>& tile) {
  const MatrixVectors m = blend_matrix_vectors(palette, tile, 0);
  const auto column = [&](std::size_t c) { return Lanes3{m.part[4 * c], m.part[4 * c + 1], m.part[4 * c + 2]}; };
  return {column(0), column(1), column(2), column(3)};
}

HWY_INLINE Lanes3 plus_product(const Lanes3& sum, const Lanes3& column, Wide s) {
  return {hn::MulAdd(column.x, s, sum.x), hn::MulAdd(column.y, s, sum.y), hn::MulAdd(column.z, s, sum.z)};
}
HWY_INLINE Lanes3 transform_points(const ScalarMatrix& m, const Lanes3& p) {
  return plus_product(plus_product(plus_product(m.c3, m.c0, p.x), m.c1, p.y), m.c2, p.z);
}
HWY_INLINE Lanes3 transform_vectors(const ScalarMatrix& m, const Lanes3& v) {
  return plus_product(plus_product(times(m.c0, v.x), m.c1, v.y), m.c2, v.z);
}

/// Normals, not yet unit; zero where the scalar path has to find their side (OutwardSide).
/// eq   M n, or sign(det M) cof(M) n
HWY_INLINE Lanes3 moved_normals(const ScalarMatrix& m, const Lanes3& n, bool cofactor_rule) {
  if (!cofactor_rule) return transform_vectors(m, n);
  const auto sum = [](const Lanes3& v) { return hn::Add(hn::Add(v.x, v.y), v.z); };
  const ScalarMatrix cof{cross(m.c1, m.c2), cross(m.c2, m.c0), cross(m.c0, m.c1), m.c3};
  const auto squares = [&](Wide a, Wide b, Wide c) { return hn::MulAdd(c, c, hn::MulAdd(b, b, hn::Mul(a, a))); };
  const Lanes3 rows{squares(m.c0.x, m.c1.x, m.c2.x), squares(m.c0.y, m.c1.y, m.c2.y), squares(m.c0.z, m.c1.z, m.c2.z)};
  const Lanes3 along{hn::Mul(m.c0.x, cof.c0.x), hn::Mul(m.c0.y, cof.c0.y), hn::Mul(m.c0.z, cof.c0.z)};
  const OutwardSide outward(sum(along), sum(rows));
  const Lanes3 moved = transform_vectors(cof, n);
  return {outward.turn(moved.x), outward.turn(moved.y), outward.turn(moved.z)};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
