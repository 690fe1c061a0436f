// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "runtime/base/contract.h"

namespace sinew {

static_assert(std::endian::native == std::endian::little, "byte streams are the memory of little-endian machines");

/// Writes numbers and arrays of numbers; an array is written as its count and its elements.
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

/// Reads the output of ByteWriter. Past the end, numbers are 0, arrays are empty, and ended() is true.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes, std::size_t offset = 0) : bytes_(bytes), at_(offset) {}

  template <class T>
  T number() {
    T value{};
    if (!has(sizeof(T))) return value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  /// If the count of the array exceeds the remaining bytes, the stream ends and nothing is allocated.
  /// out   the array, and behind it `padding` zeros
  template <class T>
  std::vector<T> numbers(std::size_t padding = 0) {
    const auto count = number<std::uint32_t>();
    if (count > (bytes_.size() - at_) / sizeof(T)) ended_ = true;
    const std::size_t size = ended_ ? 0 : count;
    std::vector<T> values(size + padding);
    if (size > 0) std::memcpy(values.data(), bytes_.data() + at_, size * sizeof(T));
    at_ += size * sizeof(T);
    return values;
  }
  void skip(std::size_t size) noexcept { at_ += has(size) ? size : 0; }
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

/// Writes a varint (LEB128): groups of seven bits, the lowest first; the eighth bit is set in all but the last.
inline void write_varint(std::uint32_t number, ByteWriter& out) {
  for (std::uint32_t more = 1; more != 0; number >>= 7) {
    more = number > 0x7f ? 0x80 : 0;
    out.add(static_cast<std::uint8_t>((number & 0x7f) | more));
  }
}

inline std::uint32_t read_varint(ByteReader& in) {
  std::uint8_t byte = in.number<std::uint8_t>();
  std::uint32_t number = byte & 0x7fu;
  for (std::uint32_t shift = 7; (byte & 0x80) != 0 && shift < 32; shift += 7) {
    byte = in.number<std::uint8_t>();
    number |= (byte & 0x7fu) << shift;
  }
  return number;
}

/// Writes rising numbers as the varints of the gaps between them.
inline void write_rising(std::span<const std::uint32_t> numbers, ByteWriter& out) {
  out.add(static_cast<std::uint32_t>(numbers.size()));
  std::uint32_t before = 0;
  for (const std::uint32_t number : numbers) write_varint(number - std::exchange(before, number), out);
}

inline std::vector<std::uint32_t> read_rising(ByteReader& in) {
  std::vector<std::uint32_t> numbers;
  std::uint32_t before = 0;
  auto left = in.number<std::uint32_t>();
  numbers.reserve(std::min<std::size_t>(left, in.left()));  // a varint takes at least one byte
  for (; left > 0 && !in.ended(); --left) numbers.push_back(before += read_varint(in));
  return numbers;
}

/// Writes a float as its distance from an expected one, counted in representable floats, as a zigzag-coded varint. It
/// takes one byte if at most 63 floats lie between.
inline void write_near(float number, float expected, ByteWriter& out) {
  const std::uint32_t gap = std::bit_cast<std::uint32_t>(number) - std::bit_cast<std::uint32_t>(expected);
  write_varint(gap << 1 ^ (gap >> 31 != 0 ? ~0u : 0u), out);
}

inline float read_near(float expected, ByteReader& in) {
  const std::uint32_t turned = read_varint(in), gap = turned >> 1 ^ ((turned & 1) != 0 ? ~0u : 0u);
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(expected) + gap);
}

/// The expected next key time: the last interval repeats.
inline float next_time(std::span<const float> times_s) noexcept {
  const std::size_t n = times_s.size();
  return n < 2 ? 0.0f : 2.0f * times_s[n - 1] - times_s[n - 2];
}

inline void write_times(std::span<const float> times_s, ByteWriter& out) {
  out.add(static_cast<std::uint32_t>(times_s.size()));
  for (std::size_t k = 0; k < times_s.size(); ++k) write_near(times_s[k], next_time(times_s.first(k)), out);
}

inline std::vector<float> read_times(ByteReader& in) {
  std::vector<float> times_s;
  auto left = in.number<std::uint32_t>();
  times_s.reserve(std::min<std::size_t>(left, in.left()));
  for (; left > 0 && !in.ended(); --left) times_s.push_back(read_near(next_time(times_s), in));
  return times_s;
}

}  // namespace sinew
