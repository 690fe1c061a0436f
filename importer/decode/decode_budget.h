// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>

namespace sinew {

/// How many bytes decompression may produce in all. Bytes are taken before anything is allocated, so that a small file
/// cannot ask for gigabytes (G68).
class DecodeBudget {
 public:
  explicit DecodeBudget(std::uint64_t file_bytes, std::uint64_t most = std::numeric_limits<std::uint64_t>::max())
      : left_(std::min(most, kFree + kPerByte * std::min(file_bytes, std::uint64_t{1} << 40))) {}

  bool take(std::uint64_t bytes) noexcept {
    if (bytes > left_) return false;
    left_ -= bytes;
    return true;
  }

 private:
  static constexpr std::uint64_t kFree = std::uint64_t{64} << 20;
  static constexpr std::uint64_t kPerByte = 64;
  std::uint64_t left_ = 0;
};

}  // namespace sinew
