// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/interpolate.h"

namespace sinew {

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
