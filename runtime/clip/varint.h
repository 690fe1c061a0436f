// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "runtime/clip/byte_stream.h"

namespace sinew {

/// Numbers that are mostly small or mostly known beforehand, in as few bytes as they need, without loss: groups of
/// seven bits, the lowest first, all but the last with the eighth bit set (LEB128).
inline void write_varint(std::uint32_t number, ByteWriter& out) {
  for (std::uint32_t more = 1; more != 0; number >>= 7) {
    more = number > 0x7f ? 0x80 : 0;
    out.add(static_cast<std::uint8_t>((number & 0x7f) | more));
  }
}

inline std::uint32_t read_varint(ByteReader& in) {
  std::uint32_t number = 0;
  std::uint8_t byte = 0x80;
  for (std::uint32_t shift = 0; (byte & 0x80) != 0 && shift < 32; shift += 7) {
    byte = in.number<std::uint8_t>();
    number |= (byte & 0x7fu) << shift;
  }
  return number;
}

/// Rising numbers as the gaps between them.
inline void write_rising(std::span<const std::uint32_t> numbers, ByteWriter& out) {
  out.add(static_cast<std::uint32_t>(numbers.size()));
  std::uint32_t before = 0;
  for (const std::uint32_t number : numbers) write_varint(number - std::exchange(before, number), out);
}

inline std::vector<std::uint32_t> read_rising(ByteReader& in) {
  std::vector<std::uint32_t> numbers;
  std::uint32_t before = 0;
  for (auto left = in.number<std::uint32_t>(); left > 0 && !in.ended(); --left)
    numbers.push_back(before += read_varint(in));
  return numbers;
}

/// A number as how many floats it lies from another, one side and the other in turn: a byte for one that is next to it.
inline void write_near(float number, float expected, ByteWriter& out) {
  const std::uint32_t gap = std::bit_cast<std::uint32_t>(number) - std::bit_cast<std::uint32_t>(expected);
  write_varint(gap << 1 ^ (gap >> 31 != 0 ? ~0u : 0u), out);
}

inline float read_near(float expected, ByteReader& in) {
  const std::uint32_t turned = read_varint(in), gap = turned >> 1 ^ ((turned & 1) != 0 ? ~0u : 0u);
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(expected) + gap);
}

/// What a key time is, if keys are as far apart as the two before it.
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
  for (auto left = in.number<std::uint32_t>(); left > 0 && !in.ended(); --left)
    times_s.push_back(read_near(next_time(times_s), in));
  return times_s;
}

}  // namespace sinew
