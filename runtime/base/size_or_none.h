// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

namespace sinew {

/// True if an optional list is absent or has the expected length.
inline bool has_size_or_none(std::span<const float> numbers, std::size_t count) noexcept {
  return numbers.empty() || numbers.size() == count;
}

}  // namespace sinew
