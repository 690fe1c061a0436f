// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace sinew {

/// Makes room for `count` elements in all. Capacity at least doubles, so that room for one more each time takes linear
/// time.
template <class T>
void make_room(std::vector<T>& list, std::size_t count) {
  if (count > list.capacity()) list.reserve(std::max(count, 2 * list.capacity()));
}

}  // namespace sinew
