// SPDX-License-Identifier: MIT
// Blending of poses over Highway's lanes, one joint per lane; included once per SIMD target, so without `#pragma once`. Single
// multiplications and additions only, never fused: all targets give the same bits (N27, N28).
#if defined(SINEW_BLEND_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_BLEND_LANES_INL_H
#undef SINEW_BLEND_LANES_INL_H
#else
#define SINEW_BLEND_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "runtime/jobs/blend_poses.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A pose's stride is a multiple of 16 joints, so that whole vectors never reach past its planes.
using Floats = hn::CappedTag<float, 16>;
using Lanes = hn::Vec<Floats>;

/// Weights below this count as none: their products would be denormal numbers, a hundred times slower (N26).
constexpr float kSmallestWeight = 1e-20f;

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
  hn::StoreU(t.tx, d, p.plane(P::tx) + j), hn::StoreU(t.ty, d, p.plane(P::ty) + j), hn::StoreU(t.tz, d, p.plane(P::tz) + j);
  hn::StoreU(t.rx, d, p.plane(P::rx) + j), hn::StoreU(t.ry, d, p.plane(P::ry) + j), hn::StoreU(t.rz, d, p.plane(P::rz) + j);
  hn::StoreU(t.rw, d, p.plane(P::rw) + j);
  hn::StoreU(t.sx, d, p.plane(P::sx) + j), hn::StoreU(t.sy, d, p.plane(P::sy) + j), hn::StoreU(t.sz, d, p.plane(P::sz) + j);
}

template <class Mask>
HWY_INLINE TransformLanes choose(Mask m, const TransformLanes& a, const TransformLanes& b) {
  return {hn::IfThenElse(m, a.tx, b.tx), hn::IfThenElse(m, a.ty, b.ty), hn::IfThenElse(m, a.tz, b.tz), hn::IfThenElse(m, a.rx, b.rx),
          hn::IfThenElse(m, a.ry, b.ry), hn::IfThenElse(m, a.rz, b.rz), hn::IfThenElse(m, a.rw, b.rw), hn::IfThenElse(m, a.sx, b.sx),
          hn::IfThenElse(m, a.sy, b.sy), hn::IfThenElse(m, a.sz, b.sz)};
}

/// Weight of a layer for the joints from `j` on; masks have no padding, so their tail is copied.
HWY_INLINE Lanes weight_of(const BlendLayer& layer, std::size_t j) {
  const Floats d;
  Lanes w = hn::Set(d, layer.weight);
  if (!layer.joint_weights.empty()) {
    const std::size_t left = layer.joint_weights.size() - j;
    HWY_ALIGN float tail[16] = {};
    const float* mask = layer.joint_weights.data() + j;
    if (left < hn::Lanes(d)) {
      for (std::size_t i = 0; i < left; ++i) tail[i] = mask[i];
      mask = tail;
    }
    w = hn::Mul(w, hn::LoadU(d, mask));
  }
  return hn::IfThenElseZero(hn::Ge(w, hn::Set(d, kSmallestWeight)), w);
}

HWY_INLINE Lanes dot4(const TransformLanes& a, const TransformLanes& b) {
  return hn::Add(hn::Add(hn::Mul(a.rx, b.rx), hn::Mul(a.ry, b.ry)), hn::Add(hn::Mul(a.rz, b.rz), hn::Mul(a.rw, b.rw)));
}

HWY_INLINE Lanes add_product(Lanes sum, Lanes value, Lanes weight) { return hn::Add(sum, hn::Mul(value, weight)); }

/// Adds a weighted transform, its rotation on the side of the pivot; sign(0) = +1.
HWY_INLINE void add(TransformLanes& sum, const TransformLanes& t, Lanes weight, const TransformLanes& pivot) {
  const Floats d;
  const Lanes turned = hn::IfThenElse(hn::Lt(dot4(pivot, t), hn::Zero(d)), hn::Neg(weight), weight);
  sum.tx = add_product(sum.tx, t.tx, weight), sum.ty = add_product(sum.ty, t.ty, weight), sum.tz = add_product(sum.tz, t.tz, weight);
  sum.rx = add_product(sum.rx, t.rx, turned), sum.ry = add_product(sum.ry, t.ry, turned);
  sum.rz = add_product(sum.rz, t.rz, turned), sum.rw = add_product(sum.rw, t.rw, turned);
  sum.sx = add_product(sum.sx, t.sx, weight), sum.sy = add_product(sum.sy, t.sy, weight), sum.sz = add_product(sum.sz, t.sz, weight);
}

/// Means from sums: divided by the total weight, the rotation by its length. The aligned sum has at least the pivot's share
/// of the total as length, so there is always a direction.
HWY_INLINE TransformLanes mean(const TransformLanes& sum, Lanes total) {
  const Floats d;
  const Lanes one = hn::Set(d, 1.0f), by_total = hn::Div(one, total);
  TransformLanes m = sum;
  m.rx = hn::Mul(m.rx, by_total), m.ry = hn::Mul(m.ry, by_total), m.rz = hn::Mul(m.rz, by_total), m.rw = hn::Mul(m.rw, by_total);
  const Lanes by_length = hn::Div(one, hn::Sqrt(dot4(m, m)));
  m.rx = hn::Mul(m.rx, by_length), m.ry = hn::Mul(m.ry, by_length), m.rz = hn::Mul(m.rz, by_length), m.rw = hn::Mul(m.rw, by_length);
  m.tx = hn::Mul(m.tx, by_total), m.ty = hn::Mul(m.ty, by_total), m.tz = hn::Mul(m.tz, by_total);
  m.sx = hn::Mul(m.sx, by_total), m.sy = hn::Mul(m.sy, by_total), m.sz = hn::Mul(m.sz, by_total);
  return m;
}

/// Blends one vector of joints from `j` on.
HWY_INLINE void blend_lanes(const BlendPosesJob& job, std::size_t j) {
  const Floats d;
  const Lanes zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const TransformLanes rest = load(job.rest, j);
  Lanes weight_sum = zero, largest = zero, contributors = zero;
  TransformLanes heaviest = rest;
  for (const BlendLayer& layer : job.layers) {
    const Lanes w = weight_of(layer, j);
    heaviest = choose(hn::Gt(w, largest), load(layer.pose, j), heaviest);
    largest = hn::Max(largest, w);
    weight_sum = hn::Add(weight_sum, w);
    contributors = hn::Add(contributors, hn::IfThenElseZero(hn::Gt(w, zero), one));
  }
  const Lanes rest_weight = hn::Max(hn::Sub(one, weight_sum), zero);
  const TransformLanes pivot = choose(hn::Gt(rest_weight, largest), rest, heaviest);
  TransformLanes sum{zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
  for (const BlendLayer& layer : job.layers) add(sum, load(layer.pose, j), weight_of(layer, j), pivot);
  add(sum, rest, rest_weight, pivot);
  const TransformLanes blended = mean(sum, hn::Add(weight_sum, rest_weight));
  // Where nothing is to be blended, the one transform that counts comes out bit for bit; without any layer that is rest.
  const auto alone = hn::Or(hn::Eq(contributors, zero), hn::And(hn::Eq(contributors, one), hn::Lt(rest_weight, hn::Set(d, kSmallestWeight))));
  store(choose(alone, heaviest, blended), job.pose, j);
}

/// What the lanes of blend_lanes work out joint by joint, for layers without masks: the same for all joints.
struct SameForAllJoints {
  const BlendLayer* heaviest = nullptr;  ///< nullptr = rest
  float total = 0.0f, rest_weight = 1.0f;
  std::size_t contributors = 0;

  explicit SameForAllJoints(std::span<const BlendLayer> layers) {
    float largest = 0.0f, sum = 0.0f;
    for (const BlendLayer& layer : layers) {
      if (layer.weight < kSmallestWeight) continue;
      if (layer.weight > largest) largest = layer.weight, heaviest = &layer;
      sum += layer.weight;
      ++contributors;
    }
    rest_weight = std::max(1.0f - sum, 0.0f);
    total = sum + rest_weight;
    if (rest_weight > largest) heaviest = nullptr;
    if (contributors == 1 && rest_weight < kSmallestWeight) contributors = 0;
  }
  /// Nothing is to be blended: the heaviest transform comes out bit for bit.
  bool alone() const { return contributors == 0; }
};

/// The same means as blend_lanes, reading each pose once.
void blend_without_masks(const BlendPosesJob& job) {
  const Floats d;
  const SameForAllJoints same(job.layers);
  const PoseSpan& pivot_pose = same.heaviest == nullptr ? job.rest : same.heaviest->pose;
  const Lanes total = hn::Set(d, same.total), zero = hn::Zero(d);
  for (std::size_t j = 0; j < job.pose.joint_count; j += hn::Lanes(d)) {
    const TransformLanes pivot = load(pivot_pose, j);
    if (same.alone()) {
      store(pivot, job.pose, j);
      continue;
    }
    TransformLanes sum{zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
    for (const BlendLayer& layer : job.layers)
      if (layer.weight >= kSmallestWeight) add(sum, load(layer.pose, j), hn::Set(d, layer.weight), pivot);
    if (same.rest_weight > 0.0f) add(sum, load(job.rest, j), hn::Set(d, same.rest_weight), pivot);
    store(mean(sum, total), job.pose, j);
  }
}

void blend_all(const BlendPosesJob& job) {
  if (std::none_of(job.layers.begin(), job.layers.end(), [](const BlendLayer& layer) { return !layer.joint_weights.empty(); }))
    return blend_without_masks(job);
  for (std::size_t j = 0; j < job.pose.joint_count; j += hn::Lanes(Floats())) blend_lanes(job, j);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
