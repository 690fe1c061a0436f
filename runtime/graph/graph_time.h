// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>

namespace sinew {

/// Times of graphs are whole ticks, so that sums do not depend on how a time is cut into steps. A millisecond and the
/// frame times of 24, 25, 30, 48, 50, 60, 90, 100, 120 and 144 Hz are whole numbers of ticks.
using GraphTicks = std::int64_t;
inline constexpr GraphTicks kTicksPerSecond = 705'600'000;

/// The time of events that never occur: later than any real time.
inline constexpr GraphTicks kNever = std::int64_t{1} << 62;

/// eq   the nearest whole number; halves are rounded away from 0, as std::llround does by a call
/// in   |x| < 2^63
inline std::int64_t nearest_whole(double x) noexcept {
  const auto whole = static_cast<std::int64_t>(x);
  const double rest = x - static_cast<double>(whole);  // exact
  return whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
}

/// eq   floor(x), in the range of nearest_whole
inline double whole_below(double x) noexcept {
  const auto whole = static_cast<double>(static_cast<std::int64_t>(x));
  return whole > x ? whole - 1.0 : whole;
}

/// Converts seconds to the nearest tick.
/// in   time_s  finite, below 10^9 s
inline GraphTicks ticks_of(double time_s) noexcept {
  return nearest_whole(time_s * static_cast<double>(kTicksPerSecond));
}
/// The decimal number that an author meant by a float: 0.1 for 0.1f. It is a multiple of 0.00001. If no such multiple
/// lies within the precision of float, the float itself is returned.
inline double decimal_of(float value) noexcept {
  const double exact = static_cast<double>(value), decimal = std::nearbyint(exact * 1e5) / 1e5;
  return std::fabs(exact - decimal) <= std::fabs(exact) * 0x1p-23 ? decimal : exact;
}
/// Same for a double that was converted from a float, such as a key time. Other doubles stay as they are.
inline double decimal_of(double value) noexcept {
  const auto single = static_cast<float>(value);
  return static_cast<double>(single) == value ? decimal_of(single) : value;
}

inline double seconds_of(GraphTicks ticks) noexcept {
  return static_cast<double>(ticks) / static_cast<double>(kTicksPerSecond);
}

}  // namespace sinew
