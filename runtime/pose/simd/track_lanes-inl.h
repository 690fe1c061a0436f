// SPDX-License-Identifier: MIT
// Interpolation of blocks of tracks, one track per lane. Included once per SIMD target, so without `#pragma once`.
// Multiplications and additions are never fused, so all targets give the same bits.
#if defined(SINEW_TRACK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TRACK_LANES_INL_H
#undef SINEW_TRACK_LANES_INL_H
#else
#define SINEW_TRACK_LANES_INL_H
#endif

#include "runtime/clip/clip_layout.h"
#include "runtime/pose/simd/track_places-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Copies the values of a key bit for bit: exactly at a key nothing is interpolated.
HWY_NOINLINE void copy_key(const TrackBlock& block, std::size_t key, const TrackOutput& out) {
  const KeyRow row(block, key);
  const std::size_t value_plane = block.value_plane, components = component_count(block.property);
  for_each_place(block, out, [&](const auto& place) HWY_ATTR {
    for (std::size_t c = 0; c < components; ++c) place.store(c, row.load(value_plane + c, place.lane()));
  });
}

/// Linear interpolation of all tracks of a block.
/// eq   (1 - s) v0 + s v1
HWY_NOINLINE void lerp_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const Lanes s = hn::Set(d, at.s), r = hn::Set(d, at.r);
  const KeyRow begin(block, at.key), end(block, at.key + 1);
  for_each_place(block, out, [&](const auto& place) HWY_ATTR {
    const std::size_t lane = place.lane();
    for (std::size_t c = 0; c < place.kComponents; ++c)
      place.store(c, hn::Add(hn::Mul(begin.load(c, lane), r), hn::Mul(end.load(c, lane), s)));
  });
}

/// Values and tangents of cubic tracks at both keys of an interval.
struct HermiteRows {
  KeyRow begin, end;
  HermiteWeights weights;
  std::size_t value_plane;

  HWY_INLINE HermiteRows(const TrackBlock& block, const BetweenKeys& at)
      : begin(block, at.key), end(block, at.key + 1), weights(at), value_plane(block.value_plane) {}

  /// eq   (value0 v0 + out0 b0) + (value1 v1 + in1 a1), with the HermiteWeights value0, out0, value1, in1
  HWY_INLINE Lanes component(std::size_t c, std::size_t lane) const {
    const Floats d;
    const std::size_t n = value_plane;
    const Lanes v0 = hn::Mul(begin.load(n + c, lane), hn::Set(d, weights.value0)),
                b0 = hn::Mul(begin.load(2 * n + c, lane), hn::Set(d, weights.out0));
    const Lanes v1 = hn::Mul(end.load(n + c, lane), hn::Set(d, weights.value1)),
                a1 = hn::Mul(end.load(c, lane), hn::Set(d, weights.in1));
    return hn::Add(hn::Add(v0, b0), hn::Add(v1, a1));
  }
};

HWY_NOINLINE void hermite_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const HermiteRows rows(block, at);
  for_each_place(block, out, [&](const auto& place) HWY_ATTR {
    for (std::size_t c = 0; c < place.kComponents; ++c) place.store(c, rows.component(c, place.lane()));
  });
}

/// eq   sin x for 0 <= |x| <= pi / 2: odd minimax polynomial of degree 9 (Remez), relative error 5.4e-9
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

HWY_INLINE Lanes flushed(Lanes v) {
  return hn::IfThenElseZero(hn::Ge(hn::Abs(v), hn::Set(Floats(), kLeastComponent)), v);
}

/// Slerp along the stored arc a. The sign of a selects the shorter way.
/// eq   normalise(q0 sin(r a) + q1 sin(s a))
HWY_NOINLINE void slerp_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const Lanes s = hn::Set(d, at.s), r = hn::Set(d, at.r), one = hn::Set(d, 1.0f);
  const KeyRow begin(block, at.key), end(block, at.key + 1);
  for_each_joint_place(block, out, [&](const auto& place) HWY_ATTR {
    const std::size_t lane = place.lane();
    // Zero past the last track: arbitrary bits there could make slow denormal products.
    const Lanes arc = place.tracks(begin.load(4, lane));
    const Lanes w0 = sine(hn::Mul(r, hn::Abs(arc))), w1 = sine(hn::Mul(s, arc));
    const auto mix = [&](std::size_t c) HWY_ATTR {
      return flushed(hn::Add(hn::Mul(begin.load(c, lane), w0), hn::Mul(end.load(c, lane), w1)));
    };
    const Lanes x = mix(0), y = mix(1), z = mix(2), w = mix(3);
    const Lanes scale = hn::Div(one, hn::Sqrt(dot4(x, y, z, w)));
    place.store(0, hn::Mul(x, scale));
    place.store(1, hn::Mul(y, scale));
    place.store(2, hn::Mul(z, scale));
    place.store(3, hn::Mul(w, scale));
  });
}

/// Cubic spline of rotations: the Hermite form of four components, normalised without sign flips, as glTF defines it. A
/// sum of length zero gives the nearer key. The sum is first divided by its largest component, so that its square
/// cannot overflow or underflow.
HWY_NOINLINE void hermite_rotation_block(const TrackBlock& block, const BetweenKeys& at, const TrackOutput& out) {
  const Floats d;
  const HermiteRows rows(block, at);
  const KeyRow nearer(block, at.s < 0.5f ? at.key : at.key + 1);
  for_each_joint_place(block, out, [&](const auto& place) HWY_ATTR {
    const std::size_t lane = place.lane();
    Lanes x = rows.component(0, lane), y = rows.component(1, lane), z = rows.component(2, lane),
          w = rows.component(3, lane);
    const Lanes largest = hn::Max(hn::Max(hn::Abs(x), hn::Abs(y)), hn::Max(hn::Abs(z), hn::Abs(w)));
    x = hn::Div(x, largest);
    y = hn::Div(y, largest);
    z = hn::Div(z, largest);
    w = hn::Div(w, largest);
    const Lanes sum = dot4(x, y, z, w), length = hn::Sqrt(sum);
    const auto has_direction = hn::And(hn::Ge(sum, hn::Set(d, 1.0f)), hn::Le(sum, hn::Set(d, 4.0f)));
    place.store(0, hn::IfThenElse(has_direction, hn::Div(x, length), nearer.load(4, lane)));
    place.store(1, hn::IfThenElse(has_direction, hn::Div(y, length), nearer.load(5, lane)));
    place.store(2, hn::IfThenElse(has_direction, hn::Div(z, length), nearer.load(6, lane)));
    place.store(3, hn::IfThenElse(has_direction, hn::Div(w, length), nearer.load(7, lane)));
  });
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
