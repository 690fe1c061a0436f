// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace sinew {

/// eq   the smallest integer >= a / b, b > 0
constexpr std::int64_t divided_up(std::int64_t a, std::int64_t b) noexcept { return a / b + (a % b > 0 ? 1 : 0); }
/// eq   the largest integer <= a / b, b > 0
constexpr std::int64_t divided_down(std::int64_t a, std::int64_t b) noexcept { return a / b - (a % b < 0 ? 1 : 0); }

}  // namespace sinew
