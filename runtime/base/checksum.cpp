// SPDX-License-Identifier: MIT
#include "runtime/base/checksum.h"

#define XXH_INLINE_ALL  // compiled into this file, so that programs that link the library need no xxHash
#include <xxhash.h>

namespace sinew {

std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t seed) noexcept {
  return XXH3_64bits_withSeed(bytes.data(), bytes.size(), seed);
}

}  // namespace sinew
