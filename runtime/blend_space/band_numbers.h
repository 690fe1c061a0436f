// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

namespace sinew {

/// Precomputed numbers of the cartesian form for a pair of points: the way from the first point to the second, divided
/// by its squared length. A longer pair is that of a nearer point. The pairs of a point are sorted, the longest first.
struct CartesianPair {
  double x = 0.0, y = 0.0, length = 0.0;
};

/// Precomputed numbers of the directional form for a pair of points. The share of the way from the first point to the
/// second is a sum: angle * turn + |angle| * turn_of_opposite + (speed - speed of the first) * rise. All are 0 if a
/// point is the origin, or if both are at the same place. Internal to blend_space/
struct BandPair {
  double turn = 0.0, turn_of_opposite = 0.0, rise = 0.0;
};

/// Precomputed polar coordinates of a point, for the directional form.
struct BandPoint {
  double angle_rad = 0.0, speed = 0.0;
};

inline constexpr double kPi = 3.14159265358979323846;
/// Directions further apart than this count as opposite: neither way round is the shorter one.
inline constexpr double kOpposite_rad = 0.99 * kPi;

/// The angle from one direction to another, in [-pi, pi].
/// in   both in [-pi, pi]
inline double angle_from(double from_rad, double to_rad) noexcept {
  const double angle = to_rad - from_rad;
  return angle > kPi ? angle - 2.0 * kPi : angle < -kPi ? angle + 2.0 * kPi : angle;
}

}  // namespace sinew
