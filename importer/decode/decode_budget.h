// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <limits>

#include "importer/read/memory_budget.h"

namespace sinew {

/// Limit of the total bytes that decompression may produce. Bytes are reserved before allocation, so that a small file
/// cannot cause huge allocations.
class DecodeBudget {
 public:
  explicit DecodeBudget(std::uint64_t file_bytes, std::uint64_t most = std::numeric_limits<std::uint64_t>::max())
      : left_(allowed_bytes(file_bytes, most)) {}

  bool take(std::uint64_t bytes) noexcept {
    if (bytes > left_) return false;
    left_ -= bytes;
    return true;
  }

 private:
  std::uint64_t left_ = 0;
};

}  // namespace sinew
