// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/animation/track.h"
#include "runtime/pose/pose.h"

namespace sinew::reference {

/// Sampling and blending from the equations only, in long double with linear scans. Tracks, clips and the blend job are
/// held to it. It shares no code with the runtime.

using Real = long double;
using Numbers = std::vector<Real>;  ///< components of one value

template <class V>
Numbers numbers(const V& v) {
  if constexpr (requires { v.w; })
    return {Real(v.x), Real(v.y), Real(v.z), Real(v.w)};
  else
    return {Real(v.x), Real(v.y), Real(v.z)};
}

inline Numbers mix(const Numbers& a, Real wa, const Numbers& b, Real wb) {
  Numbers out;
  for (std::size_t i = 0; i < a.size(); ++i) out.push_back(a[i] * wa + b[i] * wb);
  return out;
}

inline Real inner_product(const Numbers& a, const Numbers& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

inline Numbers unit(const Numbers& q) { return mix(q, 1 / std::sqrt(inner_product(q, q)), q, 0); }

/// eq   Real-Time Rendering, eq. 4.53, along the arc as given; the angle from chord lengths
inline Numbers slerp(const Numbers& q, const Numbers& r, Real t) {
  const Numbers minus = mix(q, 1, r, -1), plus = mix(q, 1, r, 1);
  const Real a = 2 * std::atan2(std::sqrt(inner_product(minus, minus)), std::sqrt(inner_product(plus, plus)));
  if (a < 1e-15L) return q;
  return mix(q, std::sin((1 - t) * a) / std::sin(a), r, std::sin(t * a) / std::sin(a));
}

/// eq   as above on the short arc (glTF 2.0, Appendix C.4)
inline Numbers slerp_short(const Numbers& q, const Numbers& r, Real t) {
  return slerp(q, inner_product(q, r) < 0 ? mix(r, -1, r, 0) : r, t);
}

/// eq   glTF 2.0, Appendix C.5, in the specification's expanded form
inline Numbers cubic(const Numbers& v0, const Numbers& out0, const Numbers& in1, const Numbers& v1, Real t, Real td) {
  const Real t2 = t * t, t3 = t2 * t;
  return mix(mix(v0, 2 * t3 - 3 * t2 + 1, out0, td * (t3 - 2 * t2 + t)), 1,
             mix(v1, -2 * t3 + 3 * t2, in1, td * (t3 - t2)), 1);
}

/// The last key at or before `time_s`, by a linear scan; clamps at both ends.
inline std::size_t key_before(std::span<const float> times_s, double time_s) {
  std::size_t key = 0;
  while (key + 1 < times_s.size() && double(times_s[key + 1]) <= time_s) ++key;
  return key;
}

/// Value of a vector or rotation track at `time_s`; squad is not covered here.
template <class V>
Numbers sample(const Track<V>& track, double time_s) {
  const std::size_t k = key_before(track.times_s, time_s);
  const bool is_cubic = track.interpolation == Interpolation::cubic_spline;
  const auto value = [&](std::size_t i) { return numbers(track.values[i]); };
  const Numbers v0 = value(is_cubic ? 3 * k + 1 : k);
  const Real t0 = Real(track.times_s[k]);
  if (Real(time_s) <= t0 || k + 1 == track.times_s.size() || track.interpolation == Interpolation::step) return v0;
  const Real td = Real(track.times_s[k + 1]) - t0, s = (Real(time_s) - t0) / td;
  constexpr bool rotation = requires(V v) { v.w; };
  if (is_cubic) {
    const Numbers sum = cubic(v0, value(3 * k + 2), value(3 * k + 3), value(3 * k + 4), s, td);
    return rotation ? unit(sum) : sum;
  }
  return rotation ? slerp_short(v0, value(k + 1), s) : mix(v0, 1 - s, value(k + 1), s);
}

/// All weights of a track at `time_s`; squad is not for weights.
inline Numbers sample(const WeightTrack& track, double time_s) {
  const std::size_t k = key_before(track.times_s, time_s), n = track.target_count;
  const bool is_cubic = track.interpolation == Interpolation::cubic_spline;
  const auto row = [&](std::size_t i) {
    const auto begin = track.values.begin() + static_cast<std::ptrdiff_t>(i * n);
    return Numbers(begin, begin + static_cast<std::ptrdiff_t>(n));
  };
  const Numbers v0 = row(is_cubic ? 3 * k + 1 : k);
  const Real t0 = Real(track.times_s[k]);
  if (Real(time_s) <= t0 || k + 1 == track.times_s.size() || track.interpolation == Interpolation::step) return v0;
  const Real td = Real(track.times_s[k + 1]) - t0, s = (Real(time_s) - t0) / td;
  return is_cubic ? cubic(v0, row(3 * k + 2), row(3 * k + 3), row(3 * k + 4), s, td) : mix(v0, 1 - s, row(k + 1), s);
}

/// eq   t = sum(w t) / sum(w); q = normalise(sum(w sign(q . pivot) q)), pivot = largest weight, first on a tie
struct Blended {
  Numbers translation{0, 0, 0}, rotation{0, 0, 0, 0}, scale{0, 0, 0};
};
inline Blended blend(std::span<const Transform> poses, std::span<const Real> weights) {
  std::size_t pivot = 0;
  Real sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > weights[pivot]) pivot = i;
    sum += weights[i];
  }
  Blended out;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    out.translation = mix(out.translation, 1, numbers(poses[i].translation), weights[i] / sum);
    out.scale = mix(out.scale, 1, numbers(poses[i].scale), weights[i] / sum);
    const Numbers q = numbers(poses[i].rotation);
    out.rotation =
        mix(out.rotation, 1, q, inner_product(q, numbers(poses[pivot].rotation)) < 0 ? -weights[i] : weights[i]);
  }
  out.rotation = unit(out.rotation);
  return out;
}

inline Vec3<double> vec3_of(const Numbers& n) { return {double(n[0]), double(n[1]), double(n[2])}; }
inline Quat<double> quat_of(const Numbers& n) {
  return Quat<double>(double(n[3]), double(n[0]), double(n[1]), double(n[2]));
}

}  // namespace sinew::reference
