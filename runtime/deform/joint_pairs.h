// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

#include "runtime/pose/joint_palette.h"

namespace sinew {

/// True if all indices of the pairs are below `count`.
inline bool are_in_range(std::span<const JointPair> pairs, std::size_t count) noexcept {
  return std::all_of(pairs.begin(), pairs.end(),
                     [count](const JointPair& pair) { return pair.first < count && pair.second < count; });
}

}  // namespace sinew
