// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace sinew {

/// For each vertex, the first vertex with the same key. Compares bits, except that -0 equals +0.
/// in    keys[V * stride]   `stride` floats for each vertex
/// cost  O(V * stride) expected
std::vector<std::uint32_t> weld(std::span<const float> keys, std::size_t stride);

}  // namespace sinew
