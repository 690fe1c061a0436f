// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>

namespace sinew {

/// Times of graphs are whole ticks, so that sums do not depend on how a time is cut into steps. A tick divides a
/// millisecond and the frame times of 24, 25, 30, 48, 50, 60, 90, 100, 120 and 144 Hz without rest.
using GraphTicks = std::int64_t;
inline constexpr GraphTicks kTicksPerSecond = 705'600'000;

/// Longer than any time that occurs: "never".
inline constexpr GraphTicks kNever = std::int64_t{1} << 62;

/// in   time_s  finite, below 10^9 s
inline GraphTicks ticks_of(double time_s) noexcept {
  return static_cast<GraphTicks>(std::llround(time_s * static_cast<double>(kTicksPerSecond)));
}
/// The number that somebody wrote, of the float that it became: 0.1f stands for 0.1. Numbers that are no multiples of
/// 0.00001 within the precision of float stay as they are.
inline double decimal_of(float value) noexcept {
  const double exact = static_cast<double>(value), decimal = std::nearbyint(exact * 1e5) / 1e5;
  return std::fabs(exact - decimal) <= std::fabs(exact) * 0x1p-23 ? decimal : exact;
}
/// The same of a time that was a float once, such as a key time.
inline double decimal_of(double value) noexcept {
  const auto single = static_cast<float>(value);
  return static_cast<double>(single) == value ? decimal_of(single) : value;
}

inline double seconds_of(GraphTicks ticks) noexcept {
  return static_cast<double>(ticks) / static_cast<double>(kTicksPerSecond);
}

}  // namespace sinew
