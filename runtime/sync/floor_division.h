// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>

namespace sinew {

/// eq   x = quotient * by + rest, 0 <= rest < by
struct FloorDivision {
  std::int64_t quotient;
  std::size_t rest;
};

inline FloorDivision floor_division(std::int64_t x, std::size_t by) noexcept {
  const auto divisor = static_cast<std::int64_t>(by);
  const std::int64_t truncated = x / divisor, rest = x % divisor;
  return rest < 0 ? FloorDivision{truncated - 1, static_cast<std::size_t>(rest + divisor)}
                  : FloorDivision{truncated, static_cast<std::size_t>(rest)};
}

/// Keeps shares and phases below 1 if rounding made them 1.
inline double below_1(double x) noexcept { return x < 1.0 ? x : 1.0 - std::numeric_limits<double>::epsilon() / 2; }

}  // namespace sinew
