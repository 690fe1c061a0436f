// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace sinew {

/// Hash of numbers by their bits: the step of 64-bit FNV-1a (Fowler, Noll, Vo) taken over 32-bit words. Each step is
/// one to one, so that two runs that differ in a single number never agree.
/// Its values are stored: in the pose files that `sinew verify` compares, and in the tests' golden hashes. So the step
/// stays as it is; checksums of files are base/checksum.h.
class BitHash {
 public:
  /// in   values  of a type made of 32-bit or 64-bit numbers, without padding
  template <class T, std::size_t kCount>
  BitHash& add(std::span<T, kCount> values) noexcept {
    static_assert(sizeof(T) % sizeof(std::uint32_t) == 0);
    const std::span<const std::byte> bytes = std::as_bytes(values);
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint32_t)) {
      std::uint32_t word;
      std::memcpy(&word, &bytes[i], sizeof word);
      value_ = (value_ ^ word) * 0x100000001b3ull;
    }
    return *this;
  }
  std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ull;
};

}  // namespace sinew
