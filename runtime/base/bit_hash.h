// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace sinew {

/// Hash of the bits of numbers: 64-bit FNV-1a (Fowler, Noll, Vo), fed with 32-bit words instead of bytes. Each step is
/// a bijection of the state, so two inputs that differ in one word never have the same hash. Hash values are stored,
/// in the pose files of `sinew verify` and in the golden hashes of the tests: never change the function. Files use
/// checksum() (base/checksum.h) instead.
class BitHash {
 public:
  /// Adds the bits of all values to the hash.
  /// in   values  elements of a type made of 32-bit or 64-bit numbers, without padding
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
