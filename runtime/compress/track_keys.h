// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "runtime/animation/track_sample.h"
#include "runtime/math/quaternion.h"

namespace sinew {

/// The largest number in [known, most] for which `holds` is true, if it is true up to there and false above. `known`
/// holds. Doubles the step, then halves it.
template <class Holds>
std::size_t last_that_holds(std::size_t known, std::size_t most, const Holds& holds) {
  std::size_t step = 1, good = known, bad = most + 1;
  while (good + step < bad) {
    if (holds(good + step)) {
      good += step;
      step *= 2;
    } else {
      bad = good + step;
    }
    if (good + step >= bad) step = std::min(step, (bad - good) / 2);
    if (step == 0) break;
  }
  return good;
}

inline Vec3<double> value_of(const Vec3Track& track, std::size_t key) {
  return Vec3<double>(track.values[value_row(track.interpolation, key)]);
}
inline Quat<double> value_of(const QuatTrack& track, std::size_t key) {
  return quat_cast<double>(track.values[value_row(track.interpolation, key)]);
}
inline double between(double a, double b, double at) noexcept { return (at - a) / (b - a); }

inline double distance_of(const Vec3<double>& a, const Vec3<double>& b) { return safe_length(a - b); }
inline double distance_of(const Quat<double>& a, const Quat<double>& b) {
  const Quat<double> d = a - aligned_with(a, b);
  return std::sqrt(quat_dot(d, d));
}

/// The key whose value is nearest to two keys that are far apart.
template <class V>
std::uint32_t middle_key(const Track<V>& track) {
  const auto farthest_from = [&](std::size_t key) {
    std::size_t far = key;
    double most = 0.0;
    for (std::size_t other = 0; other < track.key_count(); ++other) {
      const double apart = distance_of(value_of(track, key), value_of(track, other));
      if (apart > most) far = other;
      most = std::max(most, apart);
    }
    return far;
  };
  const std::size_t one = farthest_from(0), other = farthest_from(one);
  std::uint32_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t key = 0; key < track.key_count(); ++key) {
    const double most = std::max(distance_of(value_of(track, key), value_of(track, one)),
                                 distance_of(value_of(track, key), value_of(track, other)));
    if (most < least) best = key;
    least = std::min(least, most);
  }
  return best;
}

}  // namespace sinew
