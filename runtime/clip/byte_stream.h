// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "runtime/base/contract.h"

namespace sinew {

static_assert(std::endian::native == std::endian::little, "byte streams are the memory of little-endian machines");

/// Numbers and arrays of numbers one after another; an array is its count and its elements.
class ByteWriter {
 public:
  template <class T>
  void add(const T& number) {
    static_assert(std::is_arithmetic_v<T>);
    add_raw(&number, sizeof(T));
  }
  template <class T>
  void add(std::span<const T> numbers) {
    static_assert(std::is_arithmetic_v<T>);
    CONTRACT(numbers.size() <= 0xffffffffu);
    add(static_cast<std::uint32_t>(numbers.size()));
    add_raw(numbers.data(), numbers.size_bytes());
  }
  std::vector<std::byte>& bytes() noexcept { return bytes_; }

 private:
  void add_raw(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  std::vector<std::byte> bytes_;
};

/// Reads what ByteWriter wrote. After the end everything reads as 0 or empty, and `ended` tells.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes, std::size_t offset = 0) : bytes_(bytes), at_(offset) {}

  template <class T>
  T number() {
    T value{};
    if (has(sizeof(T))) std::memcpy(&value, bytes_.data() + at_, sizeof(T)), at_ += sizeof(T);
    return value;
  }
  /// The count is believed only as far as there are bytes: a wrong one allocates nothing.
  template <class T>
  std::vector<T> numbers() {
    const auto count = number<std::uint32_t>();
    if (count > (bytes_.size() - at_) / sizeof(T)) ended_ = true;
    std::vector<T> values(ended_ ? 0 : count);
    if (!values.empty()) std::memcpy(values.data(), bytes_.data() + at_, values.size() * sizeof(T));
    at_ += values.size() * sizeof(T);
    return values;
  }
  bool ended() const noexcept { return ended_; }
  std::size_t offset() const noexcept { return at_; }
  std::size_t left() const noexcept { return bytes_.size() - at_; }

 private:
  bool has(std::size_t size) noexcept {
    ended_ = ended_ || size > bytes_.size() - at_;
    return !ended_;
  }
  std::span<const std::byte> bytes_;
  std::size_t at_;
  bool ended_ = false;
};

}  // namespace sinew
