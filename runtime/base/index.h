// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sinew {

inline constexpr std::uint32_t kNone = 0xffffffffu;  ///< "no index": no parent, no skin, no material

/// True if every index is below `count`. The loop has no branch, so compilers vectorise it. It works on targets
/// without an unsigned comparison, since the top bit of (i - count) & ~i is set exactly when i < count <= 2^31.
/// cost O(n), memory-bound
template <class Index>
bool all_below(const std::vector<Index>& indices, std::size_t count) noexcept {
  if (count > std::size_t{1} << 31)
    return std::all_of(indices.begin(), indices.end(), [&](Index i) { return i < count; });
  const auto end = static_cast<std::uint32_t>(count);
  std::uint32_t below = 0x80000000u;
  for (const std::uint32_t i : indices) below &= (i - end) & ~i;
  return below != 0;
}

}  // namespace sinew
