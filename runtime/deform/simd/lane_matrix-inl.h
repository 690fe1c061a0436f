// SPDX-License-Identifier: MIT
// A matrix that all lanes of a tile share. It uses the operations of blend_columns-inl.h in the same order, so results
// have the same bits. On the scalar target a tile is one vertex, so all matrices are of this kind.
#if defined(SINEW_LANE_MATRIX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANE_MATRIX_INL_H_
#undef SINEW_LANE_MATRIX_INL_H_
#else
#define SINEW_LANE_MATRIX_INL_H_
#endif

#include "runtime/deform/simd/blend_matrix-inl.h"
#include "runtime/deform/simd/lane_memory-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

struct LaneMatrix {
  Lanes3 c0, c1, c2, c3;
};

#if HWY_TARGET == HWY_SCALAR

template <int kCount>
HWY_INLINE LaneMatrix blend_lane_matrix(const PaletteBases& palette, const TileInfluences<kCount>& tile) {
  const MatrixVectors m = blend_matrix_vectors(palette, tile, 0);
  const auto column = [&](std::size_t c) { return Lanes3{m.part[4 * c], m.part[4 * c + 1], m.part[4 * c + 2]}; };
  return {column(0), column(1), column(2), column(3)};
}

#else

HWY_INLINE LaneMatrix lane_matrix(const JointMatrix& joint) {
  const TileTag d;
  const auto column = [&](std::size_t c) HWY_ATTR {
    const glm::vec4& of = joint.column[c];
    return Lanes3{hn::Set(d, of.x), hn::Set(d, of.y), hn::Set(d, of.z)};
  };
  return {column(0), column(1), column(2), column(3)};
}

#endif  // HWY_TARGET

HWY_INLINE Lanes3 plus_product(const Lanes3& sum, const Lanes3& column, Wide s) {
  return {hn::MulAdd(column.x, s, sum.x), hn::MulAdd(column.y, s, sum.y), hn::MulAdd(column.z, s, sum.z)};
}
HWY_INLINE Lanes3 transform_points(const LaneMatrix& m, const Lanes3& p) {
  return plus_product(plus_product(plus_product(m.c3, m.c0, p.x), m.c1, p.y), m.c2, p.z);
}
HWY_INLINE Lanes3 transform_vectors(const LaneMatrix& m, const Lanes3& v) {
  return plus_product(plus_product(times(m.c0, v.x), m.c1, v.y), m.c2, v.z);
}

/// Moved normals, not normalised. A normal is zero where float cannot tell its side (OutwardSide); the scalar path then
/// computes it.
/// eq   M n, or sign(det M) cof(M) n
HWY_INLINE Lanes3 moved_normals(const LaneMatrix& m, const Lanes3& n, bool cofactor_rule) {
  if (!cofactor_rule) return transform_vectors(m, n);
  const auto sum = [](const Lanes3& v) { return hn::Add(hn::Add(v.x, v.y), v.z); };
  const LaneMatrix cof{cross(m.c1, m.c2), cross(m.c2, m.c0), cross(m.c0, m.c1), m.c3};
  const auto squares = [&](Wide a, Wide b, Wide c) { return hn::MulAdd(c, c, hn::MulAdd(b, b, hn::Mul(a, a))); };
  const Lanes3 rows{squares(m.c0.x, m.c1.x, m.c2.x), squares(m.c0.y, m.c1.y, m.c2.y), squares(m.c0.z, m.c1.z, m.c2.z)};
  const Lanes3 along{hn::Mul(m.c0.x, cof.c0.x), hn::Mul(m.c0.y, cof.c0.y), hn::Mul(m.c0.z, cof.c0.z)};
  const OutwardSide outward(sum(along), sum(rows));
  const Lanes3 moved = transform_vectors(cof, n);
  return {outward.turn(moved.x), outward.turn(moved.y), outward.turn(moved.z)};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
