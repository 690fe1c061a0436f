// SPDX-License-Identifier: MIT
// Blended dual quaternions of a tile. They are blended vertex by vertex and then transposed into lanes.
#if defined(SINEW_BLEND_DUAL_QUATERNIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_BLEND_DUAL_QUATERNIONS_INL_H_
#undef SINEW_BLEND_DUAL_QUATERNIONS_INL_H_
#else
#define SINEW_BLEND_DUAL_QUATERNIONS_INL_H_
#endif

#include "runtime/deform/simd/float8_lanes-inl.h"
#include "runtime/deform/simd/hemisphere_weights-inl.h"
#include "runtime/deform/simd/lane_memory-inl.h"
#include "runtime/deform/simd/vertex_tiles-inl.h"
#include "runtime/pose/joint_palette.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Blended dual quaternion of one vertex, not normalised (scalar_blend.h).
/// eq   sum(w sign(r . r_pivot) d_i)
/// in   one_hemisphere  all rotations are known to be in one hemisphere, so no sign is compared
template <int kCount>
HWY_INLINE Float8 blend_float8(const RigidStretch* split, const TileInfluences<kCount>& tile, std::size_t k,
                               bool one_hemisphere) {
  const VertexJoints<kCount> vertex = tile.at(k);
  const float* first = &tile.entry(split, k, 0)->rigid.real.x;
  Float8 sum = load_float8(first);
  if constexpr (kCount == 1) return sum;
  const Float8Weights<kCount> weights(vertex.weights);
  sum = times(sum, weights.of(0));
  if (one_hemisphere) {
    for (std::size_t i = 1; i < vertex.count(); ++i)
      sum = times_plus(&tile.entry(split, k, i)->rigid.real.x, weights.of(i), sum);
    return sum;
  }
  const Pivot pivot(first);
  for (std::size_t i = 1; i < vertex.count(); ++i) {
    const float* next = &tile.entry(split, k, i)->rigid.real.x;
    sum = times_plus(next, pivot.signed_weight(next, vertex.weights[i]), sum);
  }
  return sum;
}

/// Calls `body(vertex of the tile, Float8)` with the blended dual quaternion of each vertex.
template <int kCount, class Body>
HWY_INLINE void for_each_dual_quaternion(const RigidStretch* split, const TileInfluences<kCount>& tile,
                                         bool one_hemisphere, const Body& body) {
  if (kCount == 1 || one_hemisphere)
    for_each_of_tile([&](std::size_t k) HWY_ATTR { body(k, blend_float8(split, tile, k, true)); });
  else
    for_each_of_tile_by_rows([&](std::size_t k) HWY_ATTR { body(k, blend_float8(split, tile, k, false)); });
}

/// Dual quaternions of a tile, one vertex per lane, not normalised. Rotations divide by the squared length instead,
/// which needs no square root.
struct DualQuatLanes {
  Lanes4 real, dual;
  Wide twice_over_square;   ///< 2 / |real|^2
  hn::Mask<TileTag> sound;  ///< lanes whose blend did not cancel
};

HWY_INLINE DualQuatLanes dual_quat_lanes(const Lanes8& sum) {
  const TileTag d;
  // Copied member by member: compilers keep whole-struct copies in memory instead of registers.
  const Wide x = sum.low.x, y = sum.low.y, z = sum.low.z, w = sum.low.w;
  const Wide dx = sum.high.x, dy = sum.high.y, dz = sum.high.z, dw = sum.high.w;
  DualQuatLanes out;
  out.real.x = x;
  out.real.y = y;
  out.real.z = z;
  out.real.w = w;
  out.dual.x = dx;
  out.dual.y = dy;
  out.dual.z = dz;
  out.dual.w = dw;
  const Wide squared = hn::MulAdd(w, w, hn::MulAdd(z, z, hn::MulAdd(y, y, hn::Mul(x, x))));
  out.twice_over_square = hn::Div(hn::Set(d, 2.0f), squared);
  out.sound = hn::Gt(squared, hn::Set(d, 1e-12f));
  return out;
}

/// Rotates vectors.
/// eq   v' = v + w u + r x u, u = 2 / |q|^2 (r x v)   for q = (r, w)
HWY_INLINE Lanes3 rotate(const DualQuatLanes& m, const Lanes3& v) {
  const Lanes3 r{m.real.x, m.real.y, m.real.z}, twice = times(cross(r, v), m.twice_over_square);
  return plus(
      {hn::MulAdd(twice.x, m.real.w, v.x), hn::MulAdd(twice.y, m.real.w, v.y), hn::MulAdd(twice.z, m.real.w, v.z)},
      cross(r, twice));
}

/// Rotates points, then translates them.
/// eq   p' = p + 2 / |r|^2 (w a + r x a - d.w r), a = r x p + d.v: rotation and translation share the products with r
HWY_INLINE Lanes3 move_points(const DualQuatLanes& m, const Lanes3& p) {
  const Wide x = m.real.x, y = m.real.y, z = m.real.z, w = m.real.w;
  const auto cross_plus = [](Wide a, Wide b, Wide c, Wide e, Wide sum)
                              HWY_ATTR { return hn::MulAdd(a, b, hn::NegMulAdd(c, e, sum)); };  // sum + a b - c e
  const Lanes3 a{cross_plus(y, p.z, z, p.y, m.dual.x), cross_plus(z, p.x, x, p.z, m.dual.y),
                 cross_plus(x, p.y, y, p.x, m.dual.z)};
  const auto part = [&](Wide axis, Wide of_a) HWY_ATTR { return hn::NegMulAdd(m.dual.w, axis, hn::Mul(w, of_a)); };
  return {hn::MulAdd(cross_plus(y, a.z, z, a.y, part(x, a.x)), m.twice_over_square, p.x),
          hn::MulAdd(cross_plus(z, a.x, x, a.z, part(y, a.y)), m.twice_over_square, p.y),
          hn::MulAdd(cross_plus(x, a.y, y, a.x, part(z, a.z)), m.twice_over_square, p.z)};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
