// SPDX-License-Identifier: MIT
// Rigid motions and stretches of a tile of vertices: blended vertex by vertex, then turned into lanes.
#if defined(SINEW_BLEND_MOTION_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_BLEND_MOTION_LANES_INL_H_
#undef SINEW_BLEND_MOTION_LANES_INL_H_
#else
#define SINEW_BLEND_MOTION_LANES_INL_H_
#endif

#include "runtime/jobs/eight_lanes-inl.h"
#include "runtime/jobs/joint_numbers.h"
#include "runtime/jobs/joint_palette.h"
#include "runtime/jobs/lanes-inl.h"
#include "runtime/jobs/vertex_tiles-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// -weight where the rotations are on opposite sides (N17): the sum (x + y) + (z + w) of the products is less than zero.
HWY_INLINE hn::Vec<EightTag> signed_weight(hn::Vec<EightTag> pivot, const float* real, float weight) {
  const EightTag d;
  const auto products = hn::Mul(pivot, hn::LoadDup128(d, real));
  const auto pairs = hn::Add(products, hn::Shuffle2301(products));
  const auto dot = hn::Add(hn::Add(pairs, hn::Shuffle1032(pairs)), hn::Zero(d));  // + 0: -0 is not less than zero
  return hn::Xor(hn::Set(d, weight), hn::And(dot, hn::SignBit(d)));
}

/// eq   sum(w sign(r . r_pivot) d_i) of one vertex (blend_motion.h), not yet unit; one_side: all signs are known to be +
template <int kCount>
HWY_INLINE Eight blend_motion_parts(const RigidStretch* split, const VertexJoints<kCount>& vertex, bool one_side) {
  const EightTag d;
  const JointNumbers<kCount> joints(vertex.joints);
  const float* first = &joints.entry(split, 0)->rigid.real.x;
  Eight sum = load_eight(first);
  if constexpr (kCount == 1) return sum;
  const auto pivot = hn::LoadDup128(d, first);
  sum = times(sum, hn::Set(d, vertex.weights[0]));
  if (one_side) {
    for (std::size_t i = 1; i < vertex.count(); ++i) sum = times_plus(&joints.entry(split, i)->rigid.real.x, hn::Set(d, vertex.weights[i]), sum);
    return sum;
  }
  for (std::size_t i = 1; i < vertex.count(); ++i) {
    const float* next = &joints.entry(split, i)->rigid.real.x;
    sum = times_plus(next, signed_weight(pivot, next, vertex.weights[i]), sum);
  }
  return sum;
}

/// Motions of a tile, one vertex a lane.
struct MotionLanes {
  Lanes4 real, dual;
  hn::Mask<TileTag> sound;  ///< the blend did not cancel
};

template <int kCount>
HWY_INLINE MotionLanes blend_motions(const RigidStretch* split, const TileInfluences<kCount>& tile, bool one_side) {
  const TileTag d;
  Eight sums[kTileSize];
  for (std::size_t k = 0; k < kTileSize; ++k) sums[k] = blend_motion_parts(split, tile.at(k), one_side);
  const Lanes8 sum = lanes_of(sums);
  if constexpr (kCount == 1) return {sum.low, sum.high, hn::Eq(hn::Zero(d), hn::Zero(d))};
  const Wide squared = dot(sum.low, sum.low);
  const Wide scale = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(squared));
  return {times(sum.low, scale), times(sum.high, scale), hn::Gt(squared, hn::Set(d, 1e-12f))};
}

/// Symmetric matrices of a tile.
struct StretchLanes {
  Wide xx, yy, zz, xy, xz, yz;
};

/// eq   S = sum(w S_i)
template <int kCount>
HWY_INLINE StretchLanes blend_stretches(const RigidStretch* split, const TileInfluences<kCount>& tile) {
  const EightTag d;
  Eight sums[kTileSize];
  for (std::size_t k = 0; k < kTileSize; ++k) {
    const VertexJoints<kCount> vertex = tile.at(k);
    const JointNumbers<kCount> joints(vertex.joints);
    sums[k] = times(load_eight(joints.entry(split, 0)->stretch), hn::Set(d, vertex.weights[0]));
    for (std::size_t i = 1; i < vertex.count(); ++i)
      sums[k] = times_plus(joints.entry(split, i)->stretch, hn::Set(d, vertex.weights[i]), sums[k]);
  }
  const Lanes8 s = lanes_of(sums);
  return {s.low.x, s.low.y, s.low.z, s.low.w, s.high.x, s.high.y};
}

HWY_INLINE Lanes3 apply(const StretchLanes& s, const Lanes3& v) {
  return {dot(Lanes3{s.xx, s.xy, s.xz}, v), dot(Lanes3{s.xy, s.yy, s.yz}, v), dot(Lanes3{s.xz, s.yz, s.zz}, v)};
}

/// The cofactor matrix of a symmetric matrix is symmetric too.
HWY_INLINE StretchLanes cofactor(const StretchLanes& s) {
  const auto minor = [](Wide a, Wide b, Wide c, Wide e) HWY_ATTR { return hn::NegMulAdd(c, e, hn::Mul(a, b)); };  // a b - c e
  return {minor(s.yy, s.zz, s.yz, s.yz), minor(s.xx, s.zz, s.xz, s.xz), minor(s.xx, s.yy, s.xy, s.xy),
          minor(s.yz, s.xz, s.xy, s.zz), minor(s.xy, s.yz, s.yy, s.xz), minor(s.xy, s.xz, s.xx, s.yz)};
}

/// eq   n' = sign(det S) cof(S) n   (conventions.h)
HWY_INLINE Lanes3 apply_to_normal(const StretchLanes& s, const Lanes3& n) {
  const StretchLanes cof = cofactor(s);
  const Wide determinant = dot(Lanes3{s.xx, s.xy, s.xz}, Lanes3{cof.xx, cof.xy, cof.xz});
  const Wide off_diagonal = dot(Lanes3{s.xy, s.xz, s.yz}, Lanes3{s.xy, s.xz, s.yz});
  const Wide squares = hn::Add(dot(Lanes3{s.xx, s.yy, s.zz}, Lanes3{s.xx, s.yy, s.zz}), hn::Add(off_diagonal, off_diagonal));
  return turned_outward(apply(cof, n), determinant, squares);
}

/// eq   v' = v + 2 w (r x v) + 2 r x (r x v)   for unit quaternions (r, w)
HWY_INLINE Lanes3 rotate(const Lanes4& q, const Lanes3& v) {
  const Lanes3 r{q.x, q.y, q.z}, once = cross(r, v), twice = plus(once, once);
  return plus({hn::MulAdd(twice.x, q.w, v.x), hn::MulAdd(twice.y, q.w, v.y), hn::MulAdd(twice.z, q.w, v.z)}, cross(r, twice));
}

/// eq   t = 2 (r.w d.v - d.w r.v + r.v x d.v)
HWY_INLINE Lanes3 translation(const MotionLanes& m) {
  const Lanes3 r{m.real.x, m.real.y, m.real.z}, e{m.dual.x, m.dual.y, m.dual.z}, c = cross(r, e);
  const auto part = [&](Wide rv, Wide dv, Wide cross_part) HWY_ATTR {
    const Wide half = hn::Add(hn::NegMulAdd(m.dual.w, rv, hn::Mul(m.real.w, dv)), cross_part);
    return hn::Add(half, half);
  };
  return {part(r.x, e.x, c.x), part(r.y, e.y, c.y), part(r.z, e.z, c.z)};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
