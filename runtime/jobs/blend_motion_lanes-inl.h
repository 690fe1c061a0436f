// SPDX-License-Identifier: MIT
// Rigid motions and stretches of four vertices, blended in lanes of vertices.
#if defined(SINEW_BLEND_MOTION_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_BLEND_MOTION_LANES_INL_H_
#undef SINEW_BLEND_MOTION_LANES_INL_H_
#else
#define SINEW_BLEND_MOTION_LANES_INL_H_
#endif

#include "runtime/jobs/influence_dispatch.h"
#include "runtime/jobs/joint_palette.h"
#include "runtime/jobs/lanes-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Four motions, one per lane.
struct MotionLanes {
  Lanes4 real, dual;
};

/// Symmetric matrices of four vertices.
struct StretchLanes {
  V4 xx, yy, zz, xy, xz, yz;
};

HWY_INLINE V4 dot(const Lanes4& a, const Lanes4& b) {
  return hn::MulAdd(a.w, b.w, hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x))));
}

HWY_INLINE Lanes4 times(const Lanes4& a, V4 s) { return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s), hn::Mul(a.w, s)}; }

HWY_INLINE Lanes4 times_plus(const Lanes4& a, V4 s, const Lanes4& sum) {
  return {hn::MulAdd(a.x, s, sum.x), hn::MulAdd(a.y, s, sum.y), hn::MulAdd(a.z, s, sum.z), hn::MulAdd(a.w, s, sum.w)};
}

/// Four floats of each of the four joints, as columns: `first` picks where in a RigidStretch they begin.
template <class First>
HWY_INLINE Lanes4 gather(const RigidStretch* const (&joint)[4], const First& first) {
  const D4 d;
  return transpose(hn::LoadU(d, first(*joint[0])), hn::LoadU(d, first(*joint[1])), hn::LoadU(d, first(*joint[2])), hn::LoadU(d, first(*joint[3])));
}

HWY_INLINE MotionLanes load_motions(const RigidStretch* const (&joint)[4]) {
  return {gather(joint, [](const RigidStretch& s) { return &s.rigid.real.x; }), gather(joint, [](const RigidStretch& s) { return &s.rigid.dual.x; })};
}

/// The i-th influence of each of the four vertices.
template <int kCount>
struct Influence {
  const RigidStretch* joint[4];
  V4 weight;

  HWY_INLINE Influence(const RigidStretch* split, const VertexJoints<kCount> (&vertices)[4], std::size_t i) {
    float weights[4];
    for (int k = 0; k < 4; ++k) {
      joint[k] = split + vertices[k].joints[i];
      weights[k] = vertices[k].weights[i];
    }
    weight = hn::LoadU(D4(), weights);
  }
};

/// As blend_motion (blend_motion.h), four vertices at once. Answers false when some blend cancels.
template <int kCount>
HWY_INLINE bool blend_motions(const RigidStretch* split, const VertexJoints<kCount> (&vertices)[4], MotionLanes& out) {
  const D4 d;
  const Influence<kCount> heaviest(split, vertices, 0);
  const MotionLanes pivot = load_motions(heaviest.joint);
  if (vertices[0].count() == 1) return out = pivot, true;
  MotionLanes sum{times(pivot.real, heaviest.weight), times(pivot.dual, heaviest.weight)};
  for (std::size_t i = 1; i < vertices[0].count(); ++i) {
    const Influence<kCount> influence(split, vertices, i);
    const MotionLanes next = load_motions(influence.joint);
    const auto opposite = hn::Lt(dot(pivot.real, next.real), hn::Zero(d));
    const V4 weight = hn::IfThenElse(opposite, hn::Neg(influence.weight), influence.weight);
    sum = {times_plus(next.real, weight, sum.real), times_plus(next.dual, weight, sum.dual)};
  }
  const V4 squared = dot(sum.real, sum.real);
  if (!hn::AllTrue(d, hn::Gt(squared, hn::Set(d, 1e-12f)))) return false;
  const V4 scale = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(squared));
  out = {times(sum.real, scale), times(sum.dual, scale)};
  return true;
}

template <int kCount>
HWY_INLINE StretchLanes blend_stretches(const RigidStretch* split, const VertexJoints<kCount> (&vertices)[4]) {
  const V4 zero = hn::Zero(D4());
  Lanes4 low{zero, zero, zero, zero}, high = low;
  for (std::size_t i = 0; i < vertices[0].count(); ++i) {
    const Influence<kCount> influence(split, vertices, i);
    low = times_plus(gather(influence.joint, [](const RigidStretch& s) { return s.stretch; }), influence.weight, low);
    high = times_plus(gather(influence.joint, [](const RigidStretch& s) { return s.stretch + 2; }), influence.weight, high);
  }
  return {low.x, low.y, low.z, low.w, high.z, high.w};  // high is zz xy xz yz
}

HWY_INLINE Lanes3 apply(const StretchLanes& s, const Lanes3& v) {
  return {dot(Lanes3{s.xx, s.xy, s.xz}, v), dot(Lanes3{s.xy, s.yy, s.yz}, v), dot(Lanes3{s.xz, s.yz, s.zz}, v)};
}

/// The cofactor matrix of a symmetric matrix is symmetric too.
HWY_INLINE StretchLanes cofactor(const StretchLanes& s) {
  const auto minor = [](V4 a, V4 b, V4 c, V4 e) HWY_ATTR { return hn::NegMulAdd(c, e, hn::Mul(a, b)); };  // a b - c e
  return {minor(s.yy, s.zz, s.yz, s.yz), minor(s.xx, s.zz, s.xz, s.xz), minor(s.xx, s.yy, s.xy, s.xy),
          minor(s.yz, s.xz, s.xy, s.zz), minor(s.xy, s.yz, s.yy, s.xz), minor(s.xy, s.xz, s.xx, s.yz)};
}

/// eq   n' = sign(det S) cof(S) n   (conventions.h)
HWY_INLINE Lanes3 apply_to_normal(const StretchLanes& s, const Lanes3& n) {
  const StretchLanes cof = cofactor(s);
  const V4 determinant = dot(Lanes3{s.xx, s.xy, s.xz}, Lanes3{cof.xx, cof.xy, cof.xz});
  const V4 off_diagonal = dot(Lanes3{s.xy, s.xz, s.yz}, Lanes3{s.xy, s.xz, s.yz});
  const V4 squares = hn::Add(dot(Lanes3{s.xx, s.yy, s.zz}, Lanes3{s.xx, s.yy, s.zz}), hn::Add(off_diagonal, off_diagonal));
  return turned_outward(apply(cof, n), determinant, squares);
}

/// eq   v' = v + 2 w (r x v) + 2 r x (r x v)   for unit quaternions (r, w)
HWY_INLINE Lanes3 rotate(const Lanes4& q, const Lanes3& v) {
  const Lanes3 r{q.x, q.y, q.z};
  const Lanes3 once = cross(r, v), twice{hn::Add(once.x, once.x), hn::Add(once.y, once.y), hn::Add(once.z, once.z)};
  const Lanes3 again = cross(r, twice);
  return {hn::Add(hn::MulAdd(twice.x, q.w, v.x), again.x), hn::Add(hn::MulAdd(twice.y, q.w, v.y), again.y),
          hn::Add(hn::MulAdd(twice.z, q.w, v.z), again.z)};
}

/// eq   t = 2 (r.w d.v - d.w r.v + r.v x d.v)
HWY_INLINE Lanes3 translation(const MotionLanes& m) {
  const Lanes3 r{m.real.x, m.real.y, m.real.z}, e{m.dual.x, m.dual.y, m.dual.z};
  const Lanes3 c = cross(r, e);
  const auto part = [&](V4 rv, V4 dv, V4 cross_part) HWY_ATTR {
    const V4 half = hn::Add(hn::NegMulAdd(m.dual.w, rv, hn::Mul(m.real.w, dv)), cross_part);
    return hn::Add(half, half);
  };
  return {part(r.x, e.x, c.x), part(r.y, e.y, c.y), part(r.z, e.z, c.z)};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
