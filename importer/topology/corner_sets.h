// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace sinew {

/// Disjoint sets of triangle corners (union-find with path halving). The smallest corner represents its set, so the
/// result does not depend on the order of joins.
class CornerSets {
 public:
  explicit CornerSets(std::size_t corner_count) : parent_(corner_count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t leader(std::size_t corner) noexcept {
    auto c = static_cast<std::uint32_t>(corner);
    while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
    return c;
  }

  void join(std::size_t a, std::size_t b) noexcept {
    const std::uint32_t in_a = leader(a), in_b = leader(b);
    parent_[std::max(in_a, in_b)] = std::min(in_a, in_b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace sinew
