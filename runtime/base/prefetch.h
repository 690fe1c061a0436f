// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include <hwy/cache_control.h>

namespace sinew {

/// Asks the processor to load memory into its cache, without waiting for it. In terms of the language this accesses
/// nothing, so other threads may write to the memory at the same time.
inline void prefetch(const void* from, std::size_t byte_count) noexcept {
  constexpr std::size_t kLineBytes = 64;
  for (std::size_t at = 0; at < byte_count; at += kLineBytes) hwy::Prefetch(static_cast<const std::byte*>(from) + at);
}

}  // namespace sinew
