// SPDX-License-Identifier: MIT
// Poses with one joint per lane. Included once per SIMD target, so without `#pragma once`. Multiplications and
// additions are never fused, so all targets give the same bits.
#if defined(SINEW_POSE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_POSE_LANES_INL_H
#undef SINEW_POSE_LANES_INL_H
#else
#define SINEW_POSE_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <vector>

#include "runtime/math/negligible.h"
#include "runtime/pose/blend_poses.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The stride of a pose is a multiple of 16 joints, so vectors of up to 16 lanes stay within its planes.
using Floats = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Floats>;

struct Rotations {
  Lanes x, y, z, w;
};

struct TransformLanes {
  Lanes tx, ty, tz, rx, ry, rz, rw, sx, sy, sz;
};

HWY_INLINE Lanes load(const PoseSpan& pose, PoseSpan::Plane plane, std::size_t j) {
  return hn::LoadU(Floats(), pose.plane(plane) + j);
}

HWY_INLINE TransformLanes load(const PoseSpan& p, std::size_t j) {
  using P = PoseSpan;
  return {load(p, P::tx, j), load(p, P::ty, j), load(p, P::tz, j), load(p, P::rx, j), load(p, P::ry, j),
          load(p, P::rz, j), load(p, P::rw, j), load(p, P::sx, j), load(p, P::sy, j), load(p, P::sz, j)};
}

HWY_INLINE void store(const TransformLanes& t, const PoseSpan& p, std::size_t j) {
  const Floats d;
  using P = PoseSpan;
  hn::StoreU(t.tx, d, p.plane(P::tx) + j);
  hn::StoreU(t.ty, d, p.plane(P::ty) + j);
  hn::StoreU(t.tz, d, p.plane(P::tz) + j);
  hn::StoreU(t.rx, d, p.plane(P::rx) + j);
  hn::StoreU(t.ry, d, p.plane(P::ry) + j);
  hn::StoreU(t.rz, d, p.plane(P::rz) + j);
  hn::StoreU(t.rw, d, p.plane(P::rw) + j);
  hn::StoreU(t.sx, d, p.plane(P::sx) + j);
  hn::StoreU(t.sy, d, p.plane(P::sy) + j);
  hn::StoreU(t.sz, d, p.plane(P::sz) + j);
}

template <class Mask>
HWY_INLINE TransformLanes choose(Mask m, const TransformLanes& a, const TransformLanes& b) {
  return {hn::IfThenElse(m, a.tx, b.tx), hn::IfThenElse(m, a.ty, b.ty), hn::IfThenElse(m, a.tz, b.tz),
          hn::IfThenElse(m, a.rx, b.rx), hn::IfThenElse(m, a.ry, b.ry), hn::IfThenElse(m, a.rz, b.rz),
          hn::IfThenElse(m, a.rw, b.rw), hn::IfThenElse(m, a.sx, b.sx), hn::IfThenElse(m, a.sy, b.sy),
          hn::IfThenElse(m, a.sz, b.sz)};
}

/// Loads the rotations of the joints from `j` on. All poses of a job have the same stride, so it is passed once.
HWY_INLINE Rotations load_rotations(const float* planes, std::size_t stride, std::size_t j) {
  const Floats d;
  const float* x = planes + PoseSpan::rx * stride + j;
  return {hn::LoadU(d, x), hn::LoadU(d, x + stride), hn::LoadU(d, x + 2 * stride), hn::LoadU(d, x + 3 * stride)};
}
HWY_INLINE void store(const Rotations& q, float* planes, std::size_t stride, std::size_t j) {
  const Floats d;
  float* x = planes + PoseSpan::rx * stride + j;
  hn::StoreU(q.x, d, x);
  hn::StoreU(q.y, d, x + stride);
  hn::StoreU(q.z, d, x + 2 * stride);
  hn::StoreU(q.w, d, x + 3 * stride);
}

template <class Mask>
HWY_INLINE Rotations choose(Mask m, const Rotations& a, const Rotations& b) {
  return {hn::IfThenElse(m, a.x, b.x), hn::IfThenElse(m, a.y, b.y), hn::IfThenElse(m, a.z, b.z),
          hn::IfThenElse(m, a.w, b.w)};
}

/// Weight of a layer for the joints from `j` on. Joint weights have no padding, so the last ones are copied first.
HWY_INLINE Lanes weight_of(const BlendLayer& layer, std::size_t j) {
  const Floats d;
  Lanes w = hn::Set(d, layer.weight);
  if (!layer.joint_weights.empty()) {
    const std::size_t left = layer.joint_weights.size() - j;
    const float* mask = layer.joint_weights.data() + j;
    if (HWY_LIKELY(left >= hn::Lanes(d))) {
      w = hn::Mul(w, hn::LoadU(d, mask));
    } else {
      HWY_ALIGN float tail[16] = {};
      for (std::size_t i = 0; i < left; ++i) tail[i] = mask[i];
      w = hn::Mul(w, hn::Load(d, tail));
    }
  }
  return hn::IfThenElseZero(hn::Ge(w, hn::Set(d, kNegligible)), w);
}

HWY_INLINE Lanes dot4(const Rotations& a, const Rotations& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Add(hn::Mul(a.z, b.z), hn::Mul(a.w, b.w)));
}
HWY_INLINE Rotations scaled(const Rotations& q, Lanes by) {
  return {hn::Mul(q.x, by), hn::Mul(q.y, by), hn::Mul(q.z, by), hn::Mul(q.w, by)};
}
HWY_INLINE Rotations normalised(const Rotations& q) {
  return scaled(q, hn::Div(hn::Set(Floats(), 1.0f), hn::Sqrt(dot4(q, q))));
}

/// eq   a * b, never fused
HWY_INLINE Rotations product(const Rotations& a, const Rotations& b) {
  const auto sum = [](Lanes p, Lanes q, Lanes r, Lanes s) HWY_ATTR { return hn::Add(hn::Add(p, q), hn::Add(r, s)); };
  const auto m = [](Lanes p, Lanes q) HWY_ATTR { return hn::Mul(p, q); };
  return {sum(m(a.w, b.x), m(a.x, b.w), m(a.y, b.z), hn::Neg(m(a.z, b.y))),
          sum(m(a.w, b.y), m(a.y, b.w), m(a.z, b.x), hn::Neg(m(a.x, b.z))),
          sum(m(a.w, b.z), m(a.z, b.w), m(a.x, b.y), hn::Neg(m(a.y, b.x))),
          sum(m(a.w, b.w), hn::Neg(m(a.x, b.x)), hn::Neg(m(a.y, b.y)), hn::Neg(m(a.z, b.z)))};
}

using Indices = hn::RebindToSigned<Floats>;
using IndexLanes = hn::Vec<Indices>;

/// Indices of joints or floats, for gathering and scattering.
HWY_INLINE IndexLanes load_indices(const std::vector<std::uint32_t>& from, std::size_t at) {
  const hn::RebindToUnsigned<Floats> d;
  return hn::BitCast(Indices(), hn::LoadU(d, from.data() + at));
}

HWY_INLINE Lanes add_product(Lanes sum, Lanes value, Lanes weight) { return hn::Add(sum, hn::Mul(value, weight)); }

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
