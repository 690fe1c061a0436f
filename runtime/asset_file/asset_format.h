// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>

namespace sinew {

static_assert(std::endian::native == std::endian::little, "asset files are the memory of little-endian machines");

inline constexpr char kAssetMagic[8] = {'S', 'I', 'N', 'E', 'W', 'A', 'S', 'T'};

/// How a block is stored: 0 = unpacked, 1 = one zstd frame.
inline constexpr std::uint32_t kPackedByZstd = 1;

/// Limit for the number of blocks. It exceeds the number of kinds, so that later versions have room.
inline constexpr std::uint32_t kMaxBlocks = 64;

/// Arrays of numbers begin at multiples of this many bytes from the start of their block.
inline constexpr std::size_t kArrayAlignment = 16;

}  // namespace sinew
