// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace sinew {

/// The joints of one vertex, to find their entries in a palette of cache lines. Four are read at once: loads are what
/// blending spends its time on.
template <int kCount>
class JointNumbers {
 public:
  explicit JointNumbers(const std::uint16_t* joints) noexcept : joints_(joints) {
    if constexpr (kAtOnce) std::memcpy(&all_, joints, sizeof(std::uint16_t) * kCount);
  }

  template <class Entry>
  const Entry* entry(const Entry* palette, std::size_t i) const noexcept {
    if constexpr (!kAtOnce) return palette + joints_[i];
    static_assert(sizeof(Entry) == kLine);
    const std::uint64_t number_times_line = i == 0 ? all_ * kLine : all_ >> (16 * i - kLog2Line);
    return reinterpret_cast<const Entry*>(reinterpret_cast<const char*>(palette) + (number_times_line & (0xffff * kLine)));
  }

 private:
  static constexpr std::uint64_t kLine = 64, kLog2Line = 6;
  static constexpr bool kAtOnce = kCount == 4 && std::endian::native == std::endian::little;
  const std::uint16_t* joints_;
  std::uint64_t all_ = 0;
};

}  // namespace sinew
