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
inline double seconds_of(GraphTicks ticks) noexcept {
  return static_cast<double>(ticks) / static_cast<double>(kTicksPerSecond);
}

}  // namespace sinew
