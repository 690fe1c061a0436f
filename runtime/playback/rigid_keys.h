// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "runtime/math/dual_quaternion.h"
#include "runtime/math/interpolate.h"

namespace sinew {

/// A rigid transform at a time.
struct RigidKey {
  double time_s;
  Vec3<double> translation;
  Quat<double> turn;
};

/// Between two keys translations are linear and rotations use slerp.
inline RigidKey between(const RigidKey& a, const RigidKey& b, double time_s) noexcept {
  const double length = b.time_s - a.time_s, factor = length > 0.0 ? (time_s - a.time_s) / length : 1.0;
  return {time_s, a.translation + (b.translation - a.translation) * factor, slerp_short_arc(a.turn, b.turn, factor)};
}

inline double distance(const RigidKey& a, const RigidKey& b) noexcept {
  return (std::max)(safe_length(a.translation - b.translation), rotation_angle_between(a.turn, b.turn));
}

/// Finds few keys that follow a motion within a tolerance, by a greedy search over candidates.
/// in   motion(time_s)  a rigid DualQuatd
template <class Motion>
class RigidKeySearch {
 public:
  static constexpr int kChecksInInterval = 8;

  RigidKeySearch(const Motion& motion, double tolerance) : motion_(motion), tolerance_(tolerance) {}

  /// in   times_s  rising: between them the motion is smooth, and at each it may jump
  std::vector<RigidKey> keys(const std::vector<double>& times) {
    if (times.empty()) return {key_at(0.0, 0.0)};
    candidates_.assign(1, key_at(times.front(), times.front()));
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      // Where the motion jumps, the end of its interval and the start of the next one are two candidates at the same
      // time.
      const RigidKey end = key_at(times[i + 1], std::nextafter(times[i + 1], times[i]));
      add_interval(candidates_.back(), end, 0);
      const RigidKey next = key_at(times[i + 1], times[i + 1]);
      if (distance(end, next) > tolerance_) candidates_.push_back(next);
    }
    return chosen();
  }

  RigidKey key_at(double key_time_s, double time_s) const {
    const DualQuatd place = motion_(time_s);
    return {key_time_s, translation_of(place), place.real};
  }

 private:
  /// An interval is halved at most this many times while a straight line does not fit.
  static constexpr int kMostHalvings = 12;

  bool straight_line_fits(const RigidKey& from, const RigidKey& to, double within) const {
    for (int i = 1; i < kChecksInInterval; ++i) {
      const double time_s = from.time_s + (to.time_s - from.time_s) * i / kChecksInInterval;
      if (distance(between(from, to, time_s), key_at(time_s, time_s)) > within) return false;
    }
    return true;
  }

  /// Adds candidates with half of the tolerance; the other half is left for chosen().
  void add_interval(const RigidKey& from, const RigidKey& to, int halvings) {
    if (halvings < kMostHalvings && !straight_line_fits(from, to, 0.5 * tolerance_)) {
      const double middle_s = 0.5 * (from.time_s + to.time_s);
      const RigidKey middle = key_at(middle_s, middle_s);
      add_interval(from, middle, halvings + 1);
      add_interval(middle, to, halvings + 1);
    } else {
      candidates_.push_back(to);
    }
  }

  bool may_skip(std::size_t from, std::size_t to) const {
    for (std::size_t i = from + 1; i < to; ++i)
      if (candidates_[i].time_s == candidates_[i + 1].time_s ||
          distance(between(candidates_[from], candidates_[to], candidates_[i].time_s), candidates_[i]) >
              0.5 * tolerance_)
        return false;
    return straight_line_fits(candidates_[from], candidates_[to], tolerance_);
  }

  /// Doubles the length of a skip until it no longer fits, then searches between by bisection.
  std::vector<RigidKey> chosen() const {
    std::vector<RigidKey> keys{candidates_.front()};
    for (std::size_t at = 0; at + 1 < candidates_.size();) {
      std::size_t fits = at + 1, fails = candidates_.size();
      for (std::size_t length = 2; fits + 1 < fails; length *= 2) {
        const std::size_t to = std::min(at + length, candidates_.size() - 1);
        if (may_skip(at, to))
          fits = to;
        else
          fails = to;
        if (to + 1 == candidates_.size()) break;
      }
      while (fits + 1 < fails) {
        const std::size_t to = fits + (fails - fits) / 2;
        (may_skip(at, to) ? fits : fails) = to;
      }
      keys.push_back(candidates_[fits]);
      at = fits;
    }
    if (keys.size() == 2 && distance(keys[0], keys[1]) == 0.0) keys.pop_back();
    return keys;
  }

  const Motion& motion_;
  double tolerance_;
  std::vector<RigidKey> candidates_;
};

}  // namespace sinew
