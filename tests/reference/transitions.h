// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "runtime/math/interpolate.h"
#include "runtime/math/quat_log_exp.h"
#include "runtime/math/transform.h"

namespace sinew::reference {

/// Factor by which the offset between two poses fades out during an inertialized transition.
/// in   k  slope at the start;   u  progress in [0, 1]
/// eq   the quintic p with p(0) = 1, p'(0) = k and a zero of order four at its end. The end is -5 / k for k < -5, and 1
///      for others. From there on the factor is 0
inline double decay(double k, double u) {
  const double end = k < -5.0 ? -5.0 / k : 1.0;
  if (u >= end) return 0.0;
  const double s = u / end;
  return std::pow(1.0 - s, 4) * (1.0 + (k * end + 4.0) * s);
}

/// eq   the same for a value that starts at 0 with velocity 1
inline double decay_across(double u) { return u * std::pow(1.0 - u, 4); }

inline double squared(double x) { return x * x; }
inline double squared(const Vec3<double>& x) { return dot(x, x); }
inline double inner(double a, double b) { return a * b; }
inline double inner(const Vec3<double>& a, const Vec3<double>& b) { return dot(a, b); }

/// An offset that starts at x with velocity v per duration.
template <class V>
V decayed(const V& x, const V& v, double u) {
  if (!(squared(x) > 1e-20)) return v * decay_across(u) + x * decay(0.0, u);
  const double k = inner(v, x) / squared(x);
  return x * decay(k, u) + (v - x * k) * decay_across(u);
}

/// A velocity of a rotation that would grow over half a turn counts as none.
inline Vec3<double> decayed_turn(const Vec3<double>& x, const Vec3<double>& v, double u) {
  constexpr double kPi = 3.14159265358979;
  const double length = std::sqrt(squared(x)), k = squared(x) > 1e-20 ? inner(v, x) / squared(x) : 0.0;
  const double at = std::max(k, 0.0) / (5.0 * (std::max(k, 0.0) + 4.0));  // where the decay is largest
  const double across = std::sqrt(squared(v - x * k)) * decay_across(0.2);
  if (length * decay(std::max(k, 0.0), at) + across > kPi) return decayed(x, Vec3<double>(0.0), u);
  return decayed(x, v, u);
}

inline Quat<double> in_hemisphere_of(const Quat<double>& a, const Quat<double>& b) {
  return quat_dot(a, b) < 0.0 ? b * -1.0 : b;
}

/// Inertialization of one joint.     in   u  progress;   steps  of the duration
inline Transformd inertialized(const Transformd& now, const Transformd& source, const Transformd& source_before,
                               const Transformd& target, const Transformd& target_before, double u, double steps) {
  if (u >= 1.0) return now;
  const auto moved = [&](Vec3<double> Transformd::*of) {
    const Vec3<double> x = source.*of - target.*of, before = source_before.*of - target_before.*of;
    return now.*of + decayed(x, (x - before) * steps, u);
  };
  const Quat<double> turn =
      in_hemisphere_of(quat_identity<double>(), source.rotation * quat_conjugate(target.rotation));
  const Quat<double> turn_before =
      in_hemisphere_of(turn, source_before.rotation * quat_conjugate(target_before.rotation));
  const Vec3<double> x = quat_log(turn) * 2.0, before = quat_log(turn_before) * 2.0;
  const Vec3<double> left = decayed_turn(x, (x - before) * steps, u);
  return {moved(&Transformd::translation), normalised(quat_exp(left * 0.5) * now.rotation), moved(&Transformd::scale)};
}

/// Dead blending of one joint.
inline Transformd dead_blended(const Transformd& now, const Transformd& source, const Transformd& source_before,
                               double u, double steps) {
  if (u >= 1.0) return now;
  const double way = (1.0 - std::exp2(-4.0 * u)) / (4.0 * std::log(2.0)), w = u * u * (3.0 - 2.0 * u);
  const auto faded = [&](Vec3<double> Transformd::*of) {
    return (source.*of + (source.*of - source_before.*of) * (steps * way)) * (1.0 - w) + now.*of * w;
  };
  const Quat<double> step =
      in_hemisphere_of(quat_identity<double>(), source.rotation * quat_conjugate(source_before.rotation));
  Vec3<double> spin = quat_log(step) * (2.0 * steps);
  if (const double speed = std::sqrt(squared(spin)); speed > 9.2) spin *= 9.2 / speed;
  const Quat<double> went_on = quat_exp(spin * (0.5 * way)) * source.rotation;
  return {faded(&Transformd::translation),
          normalised(went_on * (1.0 - w) + in_hemisphere_of(went_on, now.rotation) * w), faded(&Transformd::scale)};
}

/// Inertialization of a morph weight or a property.
inline double inertialized(double now, double source, double source_before, double target, double target_before,
                           double u, double steps) {
  const double x = source - target, before = source_before - target_before;
  return u >= 1.0 ? now : now + decayed(x, (x - before) * steps, u);
}
inline double dead_blended(double now, double source, double source_before, double u, double steps) {
  if (u >= 1.0) return now;
  const double way = (1.0 - std::exp2(-4.0 * u)) / (4.0 * std::log(2.0)), w = u * u * (3.0 - 2.0 * u);
  return (source + (source - source_before) * steps * way) * (1.0 - w) + now * w;
}

}  // namespace sinew::reference
