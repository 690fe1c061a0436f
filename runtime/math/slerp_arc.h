// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/interpolate.h"

namespace sinew {

/// The shorter arc between two rotations, for many places on it. It keeps the angle, which does not depend on the
/// place.
/// out  at(t)  the bits of slerp_short_arc(q, r, t)
/// cost of at(): 2 sin, 1 square root
template <class T>
class SlerpArc {
 public:
  /// in   q, r  unit
  SlerpArc(const Quat<T>& q, const Quat<T>& r) noexcept : q_(q), r_(r), end_(aligned_with(q, r)) {
    angle_ = arc_angle(q_, end_);
    is_plain_ = angle_ > T(0) && quat_dot(q_ + end_, q_ + end_) > T(0) && std::sin(angle_) != T(0);
  }

  Quat<T> at(T t) const noexcept {
    if (!is_plain_ || t == T(0) || t == T(1)) return slerp_short_arc(q_, r_, t);
    return normalised(q_ * std::sin((T(1) - t) * angle_) + end_ * std::sin(t * angle_));
  }

 private:
  Quat<T> q_, r_, end_;
  T angle_;
  bool is_plain_;  // neither equal nor opposite
};

}  // namespace sinew
