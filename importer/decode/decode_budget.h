// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <limits>

#include "importer/read/memory_budget.h"

namespace sinew {

/// How many bytes decompression may produce in all. Bytes are taken before anything is allocated, so that a small file
/// cannot ask for gigabytes (G68).
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
