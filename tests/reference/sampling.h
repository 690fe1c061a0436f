// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/animation/track.h"
#include "runtime/pose/pose.h"

namespace sinew::reference {

/// Sampling and blending straight from the equations, in long double, with linear scans. Tests hold tracks, clips and
/// the blend job to it. It shares no code with the runtime.

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

/// eq   Hamilton's product of x y z w
inline Numbers product(const Numbers& a, const Numbers& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

/// eq   log(conj(from) to) of unit quaternions: the axis times half the angle of the rotation between them
inline Numbers log_between(const Numbers& from, const Numbers& to) {
  const Numbers q = product({-from[0], -from[1], -from[2], from[3]}, to), v{q[0], q[1], q[2]};
  const Real sine = std::sqrt(inner_product(v, v));
  return mix(v, sine > 0 ? std::atan2(sine, q[3]) / sine : 1 / q[3], v, 0);
}

/// eq   q exp(v) = q (v sin|v| / |v|, cos|v|)
inline Numbers turned(const Numbers& q, const Numbers& v) {
  const Real a = std::sqrt(inner_product(v, v)), ratio = a > 0 ? std::sin(a) / a : 1;
  return product(q, {v[0] * ratio, v[1] * ratio, v[2] * ratio, std::cos(a)});
}

/// Squad from key k to key k + 1 of a rotation track.
/// eq   slerp(slerp(q0, q1, s), slerp(a0, a1, s), 2 s (1 - s)), arcs as given   (Shoemake 1987; Real-Time Rendering,
///      eq. 4.55). l- and l+ are the logarithms from a key to its neighbours, h- and h+ seconds away. The parabola
///      through the three keys has the slope v = (l+ h- / h+ - l- h+ / h-) / (h- + h+) at the middle one. Squad has
///      that slope on both sides with a0 = q0 exp((v h+ - l+) / 2), a1 = q1 exp((-l- - v h-) / 2). At an end key, a =
///      q.
inline Numbers squad(const QuatTrack& track, std::size_t k, Real s) {
  const auto seconds = [&](std::size_t i) { return Real(track.times_s[i + 1]) - Real(track.times_s[i]); };
  const auto near = [&](const Numbers& to, std::size_t i) {
    const Numbers q = unit(numbers(track.values[i]));
    return mix(q, inner_product(to, q) < 0 ? -1 : 1, q, 0);
  };
  const auto slope = [](const Numbers& back, const Numbers& ahead, Real before, Real after) {
    return mix(ahead, before / after / (before + after), back, -after / before / (before + after));
  };
  const Numbers q0 = unit(numbers(track.values[k])), q1 = near(q0, k + 1);
  Numbers a0 = q0, a1 = q1;
  if (k > 0 && seconds(k - 1) > 0) {
    const Numbers back = log_between(q0, near(q0, k - 1)), ahead = log_between(q0, q1);
    a0 = turned(q0, mix(slope(back, ahead, seconds(k - 1), seconds(k)), seconds(k) / 2, ahead, Real(-0.5)));
  }
  if (k + 2 < track.times_s.size() && seconds(k + 1) > 0) {
    const Numbers back = log_between(q1, q0), ahead = log_between(q1, near(q1, k + 2));
    a1 = turned(q1, mix(back, Real(-0.5), slope(back, ahead, seconds(k), seconds(k + 1)), -seconds(k) / 2));
  }
  return slerp(slerp(q0, q1, s), slerp(a0, a1, s), 2 * s * (1 - s));
}

/// The last key at or before `time_s`, by a linear scan; clamps at both ends.
inline std::size_t key_before(std::span<const float> times_s, double time_s) {
  std::size_t key = 0;
  while (key + 1 < times_s.size() && double(times_s[key + 1]) <= time_s) ++key;
  return key;
}

/// Value of a vector or rotation track at `time_s`.
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
  if constexpr (rotation)
    if (track.interpolation == Interpolation::squad) return squad(track, k, s);
  return rotation ? slerp_short(v0, value(k + 1), s) : mix(v0, 1 - s, value(k + 1), s);
}

/// All weights of a track at `time_s`. Weight tracks never use squad.
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
