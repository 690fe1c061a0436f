// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include <hwy/cache_control.h>

namespace sinew {

/// Asks the processor to load memory that is soon read or written, without waiting for it. Reads and writes nothing as
/// far as the language is concerned, so other threads may write there meanwhile.
inline void prefetch(const void* from, std::size_t byte_count) noexcept {
  constexpr std::size_t kLineBytes = 64;
  for (std::size_t at = 0; at < byte_count; at += kLineBytes) hwy::Prefetch(static_cast<const std::byte*>(from) + at);
}

}  // namespace sinew
