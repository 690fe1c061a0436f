// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sinew {

/// Reads bits of a BasisLZ stream, lowest bit of each byte first. Bits beyond the end are zeros and set overrun().
class BasisBits {
 public:
  explicit BasisBits(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  /// in   count <= 16
  std::uint32_t take(unsigned count) noexcept {
    while (held_ < count) {
      if (at_ < bytes_.size()) {
        bits_ |= std::to_integer<std::uint32_t>(bytes_[at_++]) << held_;
      } else {
        overrun_ = true;
      }
      held_ += 8;
    }
    const std::uint32_t value = bits_ & ((1u << count) - 1u);
    bits_ >>= count;
    held_ -= count;
    return value;
  }

  /// Reads a number in chunks of `bits` bits, lowest chunk first. The bit above each chunk says if another follows.
  std::uint32_t take_chunks(unsigned bits) noexcept {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 32; shift += bits) {
      const std::uint32_t chunk = take(bits + 1);
      value |= std::uint64_t{chunk & ((1u << bits) - 1u)} << shift;
      if ((chunk >> bits) == 0) break;
    }
    return static_cast<std::uint32_t>(value);
  }

  bool overrun() const noexcept { return overrun_; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  std::uint32_t bits_ = 0;
  unsigned held_ = 0;
  bool overrun_ = false;
};

/// A canonical Huffman code of at most 16 bits (RFC 1951, 3.2.2).
class HuffmanCode {
 public:
  static constexpr unsigned kLongest = 16;
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// in    lengths   bits of each symbol's code, 0 = unused, at most kLongest
  /// out   empty if more codes are declared than their lengths leave room for
  static std::optional<HuffmanCode> make(std::span<const std::uint8_t> lengths);

  /// Reads a code as BasisLZ stores it ("Compressed Huffman Tables").
  static std::optional<HuffmanCode> read(BasisBits& bits);

  /// The next symbol; kNone if the bits are no code.
  std::uint32_t next(BasisBits& bits) const noexcept;

 private:
  std::array<std::uint32_t, kLongest + 1> count_{};  // codes of each length
  std::vector<std::uint16_t> symbols_;               // by length, then by symbol
};

}  // namespace sinew
