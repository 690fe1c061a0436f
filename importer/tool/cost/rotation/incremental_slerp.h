// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/interpolate.h"

namespace sinew::cost {

/// Slerp in constant steps: one multiplication and two additions per frame. `sinew cost` compares it with slerp; it
/// cannot seek, so the runtime does not use it.
/// eq   q[k+1] = q[k] + d[k+1], d[k+1] = d[k] - 4 sin^2(a / 2) q[k]: the recurrence q[k+1] = 2 cos(a) q[k] - q[k-1] of
///      evenly spaced points on a circle (Barrera, Hast and Bengtsson 2004), in Reinsch's form, which keeps small
///      angles
/// The state is in double, so that 100 000 steps of float rotations stay within rounding of slerp.
template <class T>
class IncrementalSlerp {
 public:
  /// Walks the shorter arc from `from` to `to` in `steps` > 0 equal steps; further steps continue beyond `to`.
  IncrementalSlerp(const Quat<T>& from, const Quat<T>& to, int steps) noexcept
      : current_(normalised(quat_cast<double>(from))) {
    const Quat<double> end = normalised(aligned_with(current_, quat_cast<double>(to)));
    const double step = arc_angle(current_, end) / steps, half_sine = std::sin(0.5 * step);
    // The first step comes from the direction of the arc. A difference of neighbours would lose the digits of a tiny
    // step.
    const Quat<double> chord = end - current_, none(0.0, 0.0, 0.0, 0.0);
    const Quat<double> tangent = normalised_or(chord - current_ * quat_dot(current_, chord), none);
    delta_ = tangent * std::sin(step) - current_ * (2.0 * half_sine * half_sine);
    factor_ = 4.0 * half_sine * half_sine;
  }

  Quat<T> current() const noexcept { return quat_cast<T>(current_); }

  void advance() noexcept {
    current_ = current_ + delta_;
    delta_ = delta_ - current_ * factor_;
  }

 private:
  Quat<double> current_, delta_{0.0, 0.0, 0.0, 0.0};
  double factor_ = 0.0;
};

}  // namespace sinew::cost
