// SPDX-License-Identifier: MIT
// Interpolation of blocks of tracks, written once over Highway's lanes; included once per SIMD target, so without `#pragma once`.
// Every lane computes its own track in the same order of single multiplications and additions, never fused: all targets
// give the same bits (N27, N28).
#if defined(SINEW_TRACK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TRACK_LANES_INL_H
#undef SINEW_TRACK_LANES_INL_H
#else
#define SINEW_TRACK_LANES_INL_H
#endif

#include <hwy/highway.h>

#include "runtime/jobs/track_output.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kLanePadding>;
using Lanes = hn::Vec<Floats>;

HWY_INLINE Lanes load(const TrackBlock& block, std::size_t key, std::size_t plane, std::size_t lane) {
  return hn::LoadU(Floats(), block.plane(key, plane) + lane);
}

/// Writes one component of the lanes from `lane` on.
HWY_INLINE void store(Lanes values, const TrackBlock& block, const TrackOutput& out, std::size_t component, std::size_t lane) {
  const Floats d;
  float* plane = out.plane(component);
  const std::size_t left = block.lane_count - lane;
  if (block.targets_adjoin && left >= hn::Lanes(d)) {
    hn::StoreU(values, d, plane + block.targets[lane]);
    return;
  }
  HWY_ALIGN float buffer[kLanePadding];
  hn::Store(values, d, buffer);
  for (std::size_t i = 0; i < HWY_MIN(left, hn::Lanes(d)); ++i) plane[block.targets[lane + i]] = buffer[i];
}

/// eq   (1 - s) v0 + s v1
void lerp_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const Lanes s = hn::Set(d, at.s), r = hn::Set(d, at.r);
  for (std::size_t c = 0; c < component_count(block.property); ++c)
    for (std::size_t lane = 0; lane < block.lane_count; lane += hn::Lanes(d))
      store(hn::Add(hn::Mul(load(block, at.key, c, lane), r), hn::Mul(load(block, at.key + 1, c, lane), s)), block, out, c, lane);
}

/// eq   (value0 v0 + out0 b0) + (value1 v1 + in1 a1), the weights being those of the Hermite form
HWY_INLINE Lanes hermite(const TrackBlock& block, const BetweenKeys& at, std::size_t component, std::size_t lane) {
  const Floats d;
  const std::size_t n = block.value_plane;
  const Lanes v0 = hn::Mul(load(block, at.key, n + component, lane), hn::Set(d, at.value0));
  const Lanes b0 = hn::Mul(load(block, at.key, 2 * n + component, lane), hn::Set(d, at.out0));
  const Lanes v1 = hn::Mul(load(block, at.key + 1, n + component, lane), hn::Set(d, at.value1));
  const Lanes a1 = hn::Mul(load(block, at.key + 1, component, lane), hn::Set(d, at.in1));
  return hn::Add(hn::Add(v0, b0), hn::Add(v1, a1));
}

void hermite_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  for (std::size_t c = 0; c < component_count(block.property); ++c)
    for (std::size_t lane = 0; lane < block.lane_count; lane += hn::Lanes(Floats()))
      store(hermite(block, at, c, lane), block, out, c, lane);
}

/// eq   sin x for 0 <= |x| <= pi / 2: odd polynomial of degree 9, least largest relative error 5.4e-9 (Remez)
HWY_INLINE Lanes sine(Lanes x) {
  const Floats d;
  const Lanes z = hn::Mul(x, x);
  Lanes p = hn::Set(d, 2.60190306065e-6f);
  p = hn::Add(hn::Set(d, -0.000198074187248f), hn::Mul(z, p));
  p = hn::Add(hn::Set(d, 0.00833302513895f), hn::Mul(z, p));
  p = hn::Add(hn::Set(d, -0.16666656684f), hn::Mul(z, p));
  p = hn::Add(hn::Set(d, 0.999999994686f), hn::Mul(z, p));
  return hn::Mul(x, p);
}

HWY_INLINE Lanes dot4(Lanes x, Lanes y, Lanes z, Lanes w) {
  return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Add(hn::Mul(z, z), hn::Mul(w, w)));
}

HWY_INLINE Lanes mix(const TrackBlock& block, std::size_t key, std::size_t component, std::size_t lane, Lanes w0, Lanes w1) {
  return hn::Add(hn::Mul(load(block, key, component, lane), w0), hn::Mul(load(block, key + 1, component, lane), w1));
}

/// eq   slerp: normalise(q0 sin(r a) + q1 sin(s a)); a is the stored arc, whose sign turns q1 to the short side (G01)
void slerp_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const Lanes s = hn::Set(d, at.s), r = hn::Set(d, at.r), one = hn::Set(d, 1.0f);
  for (std::size_t lane = 0; lane < block.lane_count; lane += hn::Lanes(d)) {
    const Lanes arc = load(block, at.key, 4, lane);
    const Lanes w0 = sine(hn::Mul(r, hn::Abs(arc))), w1 = sine(hn::Mul(s, arc));
    const Lanes x = mix(block, at.key, 0, lane, w0, w1), y = mix(block, at.key, 1, lane, w0, w1);
    const Lanes z = mix(block, at.key, 2, lane, w0, w1), w = mix(block, at.key, 3, lane, w0, w1);
    const Lanes scale = hn::Div(one, hn::Sqrt(dot4(x, y, z, w)));
    store(hn::Mul(x, scale), block, out, 0, lane);
    store(hn::Mul(y, scale), block, out, 1, lane);
    store(hn::Mul(z, scale), block, out, 2, lane);
    store(hn::Mul(w, scale), block, out, 3, lane);
  }
}

/// eq   Hermite form of four components, then normalised without sign flip (G04, G05); a sum without direction falls back to
///      the nearer key. The sum is first divided by its largest component, so that any finite length works.
void hermite_rotation_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const std::size_t nearer = at.s < 0.5f ? at.key : at.key + 1;
  for (std::size_t lane = 0; lane < block.lane_count; lane += hn::Lanes(d)) {
    Lanes x = hermite(block, at, 0, lane), y = hermite(block, at, 1, lane);
    Lanes z = hermite(block, at, 2, lane), w = hermite(block, at, 3, lane);
    const Lanes largest = hn::Max(hn::Max(hn::Abs(x), hn::Abs(y)), hn::Max(hn::Abs(z), hn::Abs(w)));
    x = hn::Div(x, largest), y = hn::Div(y, largest), z = hn::Div(z, largest), w = hn::Div(w, largest);
    const Lanes sum = dot4(x, y, z, w), length = hn::Sqrt(sum);
    const auto has_direction = hn::And(hn::Ge(sum, hn::Set(d, 1.0f)), hn::Le(sum, hn::Set(d, 4.0f)));
    store(hn::IfThenElse(has_direction, hn::Div(x, length), load(block, nearer, 4, lane)), block, out, 0, lane);
    store(hn::IfThenElse(has_direction, hn::Div(y, length), load(block, nearer, 5, lane)), block, out, 1, lane);
    store(hn::IfThenElse(has_direction, hn::Div(z, length), load(block, nearer, 6, lane)), block, out, 2, lane);
    store(hn::IfThenElse(has_direction, hn::Div(w, length), load(block, nearer, 7, lane)), block, out, 3, lane);
  }
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
