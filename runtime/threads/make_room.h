// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace sinew {

/// Reserves capacity for `count` elements in total. Capacity at least doubles, so growing one by one takes linear time.
template <class T>
void make_room(std::vector<T>& list, std::size_t count) {
  if (count > list.capacity()) list.reserve(std::max(count, 2 * list.capacity()));
}

}  // namespace sinew
