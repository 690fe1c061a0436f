// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace sinew {

/// Entries [begin, end) of a sparse attribute.
struct SparseRange {
  std::size_t begin = 0, end = 0;
};

/// First entry whose vertex is not below `vertex`. Vertices strictly increase, so entry i lies between front + i and
/// back - (n - 1 - i). Only the entries within these limits are searched: none if the vertices are consecutive.
/// in   vertices  strictly increasing     cost O(log n), O(1) for consecutive vertices
inline std::size_t first_entry_from(std::span<const std::uint32_t> vertices, std::size_t vertex) noexcept {
  if (vertices.empty() || vertex <= vertices.front()) return 0;
  if (vertex > vertices.back()) return vertices.size();
  const std::size_t last = vertices.size() - 1, behind = vertices.back() - vertex;
  const std::size_t low = behind < last ? last - behind : 0, high = std::min(last, vertex - vertices.front());
  return static_cast<std::size_t>(std::lower_bound(vertices.begin() + static_cast<std::ptrdiff_t>(low),
                                                   vertices.begin() + static_cast<std::ptrdiff_t>(high), vertex) -
                                  vertices.begin());
}

/// Entries of the vertices [first, first + count).
inline SparseRange sparse_range(std::span<const std::uint32_t> vertices, std::size_t first,
                                std::size_t count) noexcept {
  return {first_entry_from(vertices, first), first_entry_from(vertices, first + count)};
}

}  // namespace sinew
