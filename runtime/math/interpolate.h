// SPDX-License-Identifier: MIT
#pragma once
#include <limits>

#include "runtime/math/quat_log_exp.h"

namespace sinew {

/// Step interpolation.
/// eq   STEP: the value of the key at or before the time   (glTF 2.0, Appendix C.2); v1 only at t = 1
template <class V, class T>
V step(const V& v0, const V& v1, T t) noexcept {
  return t < T(1) ? v0 : v1;
}

/// Linear interpolation.
/// eq   LINEAR: (1 - t) v0 + t v1   (glTF 2.0, Appendix C.3). Returns the keys exactly at t = 0 and t = 1.
template <class V, class T>
V lerp(const V& v0, const V& v1, T t) noexcept {
  if (t == T(0)) return v0;
  if (t == T(1)) return v1;
  return v0 * (T(1) - t) + v1 * t;
}

/// Angle between unit 4-vectors in [0, pi].
/// eq   2 atan2(|q - r|, |q + r|)   (Kahan): accurate at both ends, where acos of the dot product is not
template <class T>
T arc_angle(const Quat<T>& q, const Quat<T>& r) noexcept {
  const Quat<T> difference = q - r, sum = q + r;
  return T(2) * std::atan2(std::sqrt(quat_dot(difference, difference)), std::sqrt(quat_dot(sum, sum)));
}

/// Spherical interpolation from q to r without sign flip, so it may take the longer arc (squad needs this).
/// eq   (q sin((1 - t) a) + r sin(t a)) / sin a, normalised   (Real-Time Rendering, eq. 4.53)
///      The normalisation replaces the division by sin a, so no threshold for small angles is needed.
///      Opposite q and r have no unique arc. The one through q i is taken, so the result is unit and continuous in t.
template <class T>
Quat<T> slerp_as_given(const Quat<T>& q, const Quat<T>& r, T t) noexcept {
  if (t == T(0)) return q;
  if (t == T(1)) return r;
  const T a = arc_angle(q, r);
  // Equal keys keep their bits. If they are not unit they are normalised, as every other result is.
  if (a == T(0)) return std::abs(quat_dot(q, q) - T(1)) <= T(4) * std::numeric_limits<T>::epsilon() ? q : normalised(q);
  const T w0 = std::sin((T(1) - t) * a), w1 = std::sin(t * a);
  const Quat<T> sum = q * w0 + r * w1;
  const T shortest = std::sin(a);
  if (quat_dot(q + r, q + r) > T(0) && shortest != T(0)) return normalised(sum);
  const Quat<T> turn = q * quat_xyzw(T(1), T(0), T(0), T(0));
  return normalised(q * std::cos(t * a) + turn * std::sin(t * a));
}

/// Spherical interpolation at constant speed along the shorter arc; r is negated when q . r < 0, sign(0) = +1.
/// in   q, r  unit; a length error of d turns the result by at most d      t  0..1
/// out  unit; the stored key itself, bit for bit, at t = 0 and t = 1
/// cost 1 atan2, 2 sin, 3 square roots
template <class T>
Quat<T> slerp_short_arc(const Quat<T>& q, const Quat<T>& r, T t) noexcept {
  if (t == T(1)) return r;
  return slerp_as_given(q, aligned_with(q, r), t);
}

/// Normalised linear interpolation along the shorter arc: the path of slerp at uneven speed. Largest error in degrees,
/// by degrees between the keys: 0.00015 at 5, 0.0098 at 20, 0.92 at 90, 8.15 at 180.
/// eq   normalise((1 - t) q + t s r), s = sign of q . r
template <class T>
Quat<T> nlerp_short_arc(const Quat<T>& q, const Quat<T>& r, T t) noexcept {
  if (t == T(0)) return q;
  if (t == T(1)) return r;
  const Quat<T> sum = q * (T(1) - t) + aligned_with(q, r) * t;
  return normalised_or(sum, q);
}

/// Cubic Hermite spline of glTF: tangents are per second and scaled by the key distance `td_s`.
/// eq   CUBICSPLINE   (glTF 2.0, Appendix C.5), in the factored form that keeps v1's weight exact near s = 1:
///      (1 + 2s)(1 - s)^2 v0 + td s (1 - s)^2 out0 + s^2 (3 - 2s) v1 - td s^2 (1 - s) in1
/// in   s  0..1 between the keys. Returns the keys exactly at s = 0 and s = 1.
template <class V, class T>
V hermite(const V& v0, const V& out_tangent0, const V& in_tangent1, const V& v1, T s, T td_s) noexcept {
  if (s == T(0)) return v0;
  if (s == T(1)) return v1;
  const T r = T(1) - s;
  return v0 * ((T(1) + T(2) * s) * (r * r)) + out_tangent0 * (td_s * s * (r * r)) + v1 * (s * s * (T(3) - T(2) * s)) -
         in_tangent1 * (td_s * (s * s) * r);
}

/// Cubic Hermite spline of a rotation: component-wise without sign flip, then normalised (glTF 2.0, Appendix C.5). If
/// the sum is zero, the result is the nearer key.
template <class T>
Quat<T> hermite_rotation(const Quat<T>& q0, const Quat<T>& out_tangent0, const Quat<T>& in_tangent1, const Quat<T>& q1,
                         T s, T td_s) noexcept {
  if (s == T(0)) return q0;
  if (s == T(1)) return q1;
  return normalised_or(hermite(q0, out_tangent0, in_tangent1, q1, s, td_s), s < T(0.5) ? q0 : q1);
}

/// Inner control point of squad at a key with evenly spaced neighbours.
/// eq   a = q exp(-(log(q^-1 previous) + log(q^-1 next)) / 4)   (Shoemake 1987; Real-Time Rendering, eq. 4.54)
/// in   unit keys, each on the hemisphere of its predecessor (align the whole track once with aligned_with).
///      At the ends of a track pass the key itself for the missing neighbour; equal keys give the key itself.
template <class T>
Quat<T> squad_control(const Quat<T>& previous, const Quat<T>& key, const Quat<T>& next) noexcept {
  const Quat<T> inverse = quat_conjugate(key);
  const Vec3<T> bend = quat_log(inverse * previous) + quat_log(inverse * next);
  return normalised(key * quat_exp(bend * T(-0.25)));
}

/// The two control points of a key whose neighbours are unevenly spaced: `incoming` for the interval before the key,
/// `outgoing` for the one after it.
template <class T>
struct SquadControlsT {
  Quat<T> incoming, outgoing;
};

/// Control points that make the angular velocity at the key the same on both sides.
/// eq   l- = log(q^-1 previous), l+ = log(q^-1 next);  velocity v = (l+ h- / h+ - l- h+ / h-) / (h- + h+), the slope
///      of the parabola through the three keys;  squad's own slope at its ends is (l+ + 2 log(q^-1 a)) / h+, so
///      outgoing = q exp((v h+ - l+) / 2),  incoming = q exp((-l- - v h-) / 2);  h- = h+ gives squad_control
/// in   before_s, after_s  > 0, distances to the neighbouring keys
template <class T>
SquadControlsT<T> squad_controls_uneven(const Quat<T>& previous, const Quat<T>& key, const Quat<T>& next, T before_s,
                                        T after_s) noexcept {
  const Quat<T> inverse = quat_conjugate(key);
  const Vec3<T> back = quat_log(inverse * previous), ahead = quat_log(inverse * next);
  const T ratio = after_s / before_s, share_after = after_s / (before_s + after_s), share_before = T(1) - share_after;
  // v h+ and v h-, computed from ratios only, so tiny intervals neither overflow nor underflow
  const Vec3<T> turn_after = ahead * share_before - back * (ratio * share_after);
  const Vec3<T> turn_before = ahead * (share_before / ratio) - back * share_after;
  return {normalised(key * quat_exp((-back - turn_before) * T(0.5))),
          normalised(key * quat_exp((turn_after - ahead) * T(0.5)))};
}

/// Spherical cubic between two keys; exact keys at t = 0 and t = 1.
/// eq   slerp(slerp(q0, q1, t), slerp(a0, a1, t), 2 t (1 - t))   (Real-Time Rendering, eq. 4.55), all signs as given
/// in   q0, q1 aligned neighbours;  a0 control of q0 (outgoing), a1 control of q1 (incoming)
template <class T>
Quat<T> squad(const Quat<T>& q0, const Quat<T>& a0, const Quat<T>& a1, const Quat<T>& q1, T t) noexcept {
  if (t == T(0)) return q0;
  if (t == T(1)) return q1;
  return slerp_as_given(slerp_as_given(q0, q1, t), slerp_as_given(a0, a1, t), T(2) * t * (T(1) - t));
}

}  // namespace sinew
