// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace sinew {

/// Checksum of bytes, the same on every machine and in every version. Files store it, and cache files are named by it.
/// eq   XXH3, 64 bits (Collet)
/// in   seed  0, or the checksum of the arrays before this one, to chain several
/// cost O(bytes), memory-bound
std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t seed = 0) noexcept;

}  // namespace sinew
