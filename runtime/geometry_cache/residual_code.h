// SPDX-License-Identifier: MIT
// Prefix codes of residuals. A zigzag residual is upper << width | lower: lower bits are packed, the uppers of two
// points share one word. Words are the same on every machine, because integers alone make them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/geometry_cache/block_motion.h"

namespace sinew {

inline constexpr unsigned kMaxWordBits = 11;
/// Uppers below this may share a word. A pair without a word is escaped: kMaxUpper fits its 8 raw bits.
inline constexpr std::uint32_t kWordUppers = 15, kMaxUpper = 255, kRawUpperBits = 8;
/// Bytes after the codes that the reader may read.
inline constexpr std::size_t kCodePadding = 160;
/// Bytes of the lengths of the streams of x and y, before the three streams. Codes of no block are no bytes.
inline constexpr std::size_t kCodeHeads = 2 * sizeof(std::uint32_t);

/// Bits that stand for two uppers, lowest first.
struct PairBits {
  std::uint32_t bits = 0;
  std::uint8_t length = 0;
};

/// The bits of a pair in a code.
/// in   code  [1, kResidualCodes];   a, b  at most kMaxUpper
/// eq   a word is made for weights w(a) w(b); w is geometric, and its mean grows with the code
PairBits bits_of_pair(std::uint8_t code, std::uint32_t a, std::uint32_t b) noexcept;

/// Decodes the uppers of all blocks of a frame. Any codes may be passed.
/// in   blocks  codes at most kResidualCodes
///      codes   kCodeHeads, the words of x of all blocks, then of y and z, and kCodePadding bytes of any value
/// out  uppers  [192 * blocks] 0 where a block has no code
/// err  false: words do not end where the codes do
/// cost O(points), no allocation
bool read_uppers(std::span<const BlockMotion> blocks, std::span<const std::uint8_t> codes,
                 std::span<std::uint8_t> uppers) noexcept;

/// Largest size of the codes, without padding.
constexpr std::size_t most_code_bytes(std::size_t blocks) noexcept {
  constexpr std::size_t kMostBits = kBlockNumbers / 2 * (kMaxWordBits + 2 * kRawUpperBits);
  return kCodeHeads + 3 + blocks * kMostBits / 8;
}

}  // namespace sinew
