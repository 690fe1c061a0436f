// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzz_targets.h"

namespace sinew::fuzz {

/// Reads choices from the front of an input; beyond its end all choices are zero.
class InputReader {
 public:
  explicit InputReader(Bytes input) : left_(input) {}

  std::uint32_t u8() {
    if (left_.empty()) return 0;
    const auto value = std::to_integer<std::uint32_t>(left_.front());
    left_ = left_.subspan(1);
    return value;
  }
  std::uint32_t u16() {
    const std::uint32_t low = u8();
    return low | u8() << 8;
  }
  template <class T, std::size_t N>
  const T& one_of(const std::array<T, N>& list) {
    return list[u8() % N];
  }

  Bytes rest() const noexcept { return left_; }

 private:
  Bytes left_;
};

}  // namespace sinew::fuzz
