// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace sinew {

/// Checksum of bytes, the same on every machine and in every version: what files store and caches are named by.
/// eq   XXH3, 64 bits (Collet)
/// in   seed  of several arrays in turn, the checksum of those before
/// cost O(bytes), memory-bound
std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t seed = 0) noexcept;

}  // namespace sinew
