// SPDX-License-Identifier: MIT
#include "runtime/base/checksum.h"

#define XXH_INLINE_ALL  // compiled here, so that nobody who links the library needs xxHash
#include <xxhash.h>

namespace sinew {

std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t seed) noexcept {
  return XXH3_64bits_withSeed(bytes.data(), bytes.size(), seed);
}

}  // namespace sinew
