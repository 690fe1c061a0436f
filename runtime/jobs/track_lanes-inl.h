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

#include "runtime/assets/clip_layout.h"
#include "runtime/jobs/track_places-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// The stored values of a key, bit for bit (G06).
void copy_key(const TrackBlock& block, std::size_t key, const TrackOutput& out) {
  for_each_place(block, out, [&](const Place& place) HWY_ATTR {
    for (std::size_t c = 0; c < component_count(block.property); ++c) place.store(c, load(block, key, block.value_plane + c, place.lane()));
  });
}

/// eq   (1 - s) v0 + s v1
void lerp_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const Lanes s = hn::Set(d, at.s), r = hn::Set(d, at.r);
  for_each_place(block, out, [&](const Place& place) HWY_ATTR {
    for (std::size_t c = 0; c < component_count(block.property); ++c)
      place.store(c, hn::Add(hn::Mul(load(block, at.key, c, place.lane()), r), hn::Mul(load(block, at.key + 1, c, place.lane()), s)));
  });
}

/// eq   (value0 v0 + out0 b0) + (value1 v1 + in1 a1), the weights being those of the Hermite form
HWY_INLINE Lanes hermite(const TrackBlock& block, std::size_t key, const HermiteWeights& weights, std::size_t component, std::size_t lane) {
  const Floats d;
  const std::size_t n = block.value_plane;
  const Lanes v0 = hn::Mul(load(block, key, n + component, lane), hn::Set(d, weights.value0));
  const Lanes b0 = hn::Mul(load(block, key, 2 * n + component, lane), hn::Set(d, weights.out0));
  const Lanes v1 = hn::Mul(load(block, key + 1, n + component, lane), hn::Set(d, weights.value1));
  const Lanes a1 = hn::Mul(load(block, key + 1, component, lane), hn::Set(d, weights.in1));
  return hn::Add(hn::Add(v0, b0), hn::Add(v1, a1));
}

void hermite_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const HermiteWeights weights(at);
  for_each_place(block, out, [&](const Place& place) HWY_ATTR {
    for (std::size_t c = 0; c < component_count(block.property); ++c) place.store(c, hermite(block, at.key, weights, c, place.lane()));
  });
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

HWY_INLINE Lanes flushed(Lanes v) { return hn::IfThenElseZero(hn::Ge(hn::Abs(v), hn::Set(Floats(), kLeastComponent)), v); }

HWY_INLINE Lanes mix(const TrackBlock& block, std::size_t key, std::size_t component, std::size_t lane, Lanes w0, Lanes w1) {
  return hn::Add(hn::Mul(load(block, key, component, lane), w0), hn::Mul(load(block, key + 1, component, lane), w1));
}

/// eq   slerp: normalise(q0 sin(r a) + q1 sin(s a)); a is the stored arc, whose sign turns q1 to the short side (G01)
void slerp_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const Lanes s = hn::Set(d, at.s), r = hn::Set(d, at.r), one = hn::Set(d, 1.0f);
  for_each_place(block, out, [&](const Place& place) HWY_ATTR {
    const std::size_t lane = place.lane();
    const Lanes arc = load(block, at.key, 4, lane);
    const Lanes w0 = sine(hn::Mul(r, hn::Abs(arc))), w1 = sine(hn::Mul(s, arc));
    const Lanes x = flushed(mix(block, at.key, 0, lane, w0, w1)), y = flushed(mix(block, at.key, 1, lane, w0, w1));
    const Lanes z = flushed(mix(block, at.key, 2, lane, w0, w1)), w = flushed(mix(block, at.key, 3, lane, w0, w1));
    const Lanes scale = hn::Div(one, hn::Sqrt(dot4(x, y, z, w)));
    place.store(0, hn::Mul(x, scale));
    place.store(1, hn::Mul(y, scale));
    place.store(2, hn::Mul(z, scale));
    place.store(3, hn::Mul(w, scale));
  });
}

/// eq   Hermite form of four components, then normalised without sign flip (G04, G05); a sum without direction falls back to
///      the nearer key. The sum is first divided by its largest component, so that any finite length works.
void hermite_rotation_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const HermiteWeights weights(at);
  const std::size_t nearer = at.s < 0.5f ? at.key : at.key + 1;
  for_each_place(block, out, [&](const Place& place) HWY_ATTR {
    const std::size_t lane = place.lane();
    Lanes x = hermite(block, at.key, weights, 0, lane), y = hermite(block, at.key, weights, 1, lane);
    Lanes z = hermite(block, at.key, weights, 2, lane), w = hermite(block, at.key, weights, 3, lane);
    const Lanes largest = hn::Max(hn::Max(hn::Abs(x), hn::Abs(y)), hn::Max(hn::Abs(z), hn::Abs(w)));
    x = hn::Div(x, largest), y = hn::Div(y, largest), z = hn::Div(z, largest), w = hn::Div(w, largest);
    const Lanes sum = dot4(x, y, z, w), length = hn::Sqrt(sum);
    const auto has_direction = hn::And(hn::Ge(sum, hn::Set(d, 1.0f)), hn::Le(sum, hn::Set(d, 4.0f)));
    place.store(0, hn::IfThenElse(has_direction, hn::Div(x, length), load(block, nearer, 4, lane)));
    place.store(1, hn::IfThenElse(has_direction, hn::Div(y, length), load(block, nearer, 5, lane)));
    place.store(2, hn::IfThenElse(has_direction, hn::Div(z, length), load(block, nearer, 6, lane)));
    place.store(3, hn::IfThenElse(has_direction, hn::Div(w, length), load(block, nearer, 7, lane)));
  });
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
