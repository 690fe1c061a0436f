// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/residual_code.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace sinew {
namespace {

constexpr std::size_t kPairs = std::size_t{kWordUppers} * kWordUppers, kSymbols = kPairs + 1;
constexpr std::size_t kEscape = kPairs, kEntries = std::size_t{1} << kMaxWordBits;
constexpr std::uint32_t kEntryEscapes = 1u << 8;

/// w(u + 1) / w(u) in 65536ths. The first codes are for small residuals: there zigzag pairs 1, 2 and 3, 4 weigh the
/// same.
struct Shape {
  std::uint32_t ratio;
  bool in_steps;
};
constexpr std::array<Shape, kResidualCodes> kShapes{{{2600, true},
                                                     {6500, true},
                                                     {11800, true},
                                                     {18500, true},
                                                     {26000, true},
                                                     {33500, true},
                                                     {36700, false},
                                                     {42600, false},
                                                     {47500, false}}};

/// Lengths of Huffman's code; 0 = no word.
using Lengths = std::array<std::uint8_t, kSymbols>;

std::array<std::uint64_t, kSymbols> weights_of(const Shape& shape) {
  std::array<std::uint64_t, kWordUppers + 1> one{};  // the last one is the sum of the tail
  std::uint64_t weight = std::uint64_t{1} << 28;
  std::uint64_t sum = 0;
  for (std::uint32_t u = 0; u < 256; ++u) {
    if (u > 0 && (!shape.in_steps || u % 2 == 1)) weight = weight * shape.ratio >> 16;
    one[std::min(u, kWordUppers)] += weight;
    sum += weight;
  }
  std::array<std::uint64_t, kSymbols> out{};
  std::uint64_t covered = 0;
  for (std::uint32_t a = 0; a < kWordUppers; ++a)
    for (std::uint32_t b = 0; b < kWordUppers; ++b) {
      const std::uint64_t both = (one[a] << 20) / sum * ((one[b] << 20) / sum);  // of 2^40
      if (both < std::uint64_t{1} << (40 - kMaxWordBits - 1)) continue;
      out[kWordUppers * a + b] = both;
      covered += both;
    }
  out[kEscape] = std::max<std::uint64_t>((std::uint64_t{1} << 40) - covered, 1);
  return out;
}

/// Huffman's algorithm. Of equal weights the node that was made first comes first.
Lengths huffman(const std::array<std::uint64_t, kSymbols>& weights) {
  struct Node {
    std::uint64_t weight;
    std::size_t parent;
    bool joined;
  };
  std::vector<Node> nodes;
  std::array<std::size_t, kSymbols> leaf{};
  for (std::size_t s = 0; s < kSymbols; ++s) {
    if (weights[s] == 0) continue;
    leaf[s] = nodes.size();
    nodes.push_back({weights[s], 0, false});
  }
  const auto take_lightest = [&] {
    std::size_t best = nodes.size();
    for (std::size_t n = 0; n < nodes.size(); ++n)
      if (!nodes[n].joined && (best == nodes.size() || nodes[n].weight < nodes[best].weight)) best = n;
    nodes[best].joined = true;
    return best;
  };
  for (std::size_t joins = nodes.size() - 1; joins > 0; --joins) {
    const std::size_t a = take_lightest(), b = take_lightest();
    nodes[a].parent = nodes[b].parent = nodes.size();
    nodes.push_back({nodes[a].weight + nodes[b].weight, 0, false});
  }
  Lengths lengths{};
  for (std::size_t s = 0; s < kSymbols; ++s)
    for (std::size_t n = leaf[s]; weights[s] > 0 && n + 1 < nodes.size(); n = nodes[n].parent) ++lengths[s];
  return lengths;
}

Lengths lengths_of(const Shape& shape) {
  auto weights = weights_of(shape);
  for (std::uint64_t least = std::uint64_t{1} << (40 - kMaxWordBits - 1);; least += least / 4) {
    for (std::uint64_t& weight : weights)
      if (weight > 0) weight = std::max(weight, least);
    const Lengths lengths = huffman(weights);
    if (*std::max_element(lengths.begin(), lengths.end()) <= kMaxWordBits) return lengths;
  }
}

/// A code in both directions. An entry is its pair << 16, kEntryEscapes and the length of its word.
struct Code {
  std::array<PairBits, kSymbols> words{};
  std::array<std::uint32_t, kEntries> entries{};
};

/// Words in the order of their lengths, then of their pairs; each is written from its highest bit.
Code make_code(const Shape& shape) {
  const Lengths lengths = lengths_of(shape);
  Code code;
  std::uint32_t next = 0;
  for (std::uint8_t length = 1; length <= kMaxWordBits; ++length, next <<= 1)
    for (std::uint32_t s = 0; s < kSymbols; ++s) {
      if (lengths[s] != length) continue;
      std::uint32_t bits = 0;
      for (std::uint8_t bit = 0; bit < length; ++bit) bits |= (next >> bit & 1u) << (length - 1 - bit);
      ++next;
      code.words[s] = {bits, length};
      const std::uint32_t pair = s / kWordUppers | s % kWordUppers << 8;
      const std::uint32_t entry = (s == kEscape ? kEntryEscapes : pair << 16) | length;
      for (std::size_t at = bits; at < kEntries; at += std::size_t{1} << length) code.entries[at] = entry;
    }
  return code;
}

const std::array<Code, kResidualCodes>& codes() {
  static const auto all = [] {
    std::array<Code, kResidualCodes> out;
    for (std::size_t c = 0; c < kResidualCodes; ++c) out[c] = make_code(kShapes[c]);
    return out;
  }();
  return all;
}

/// Reads bits, lowest first. A fill leaves at least 56 of them.
struct BitReader {
  const std::uint8_t* at = nullptr;
  std::uint64_t bits = 0;
  unsigned have = 0;

  void fill() noexcept {
    std::uint64_t word;
    std::memcpy(&word, at, sizeof(word));
    bits |= word << have;
    at += (63 - have) >> 3;
    have |= 56u;
  }
  std::uint32_t take(unsigned count) noexcept {
    const auto out = static_cast<std::uint32_t>(bits & ((std::uint64_t{1} << count) - 1));
    bits >>= count;
    have -= count;
    return out;
  }
  /// The first byte of which no bit was taken.
  const std::uint8_t* end() const noexcept { return at - have / 8; }
};

/// Entries of no code: pairs of zeros that take no bits.
constexpr std::array<std::uint32_t, kEntries> kZeros{};

/// One axis of a block.
struct AxisReader {
  BitReader in;
  const std::uint32_t* entries = nullptr;

  void use(std::uint8_t code, const std::array<Code, kResidualCodes>& all) noexcept {
    entries = code == 0 ? kZeros.data() : all[code - 1u].entries.data();
  }
  void read_pair(std::uint8_t* out) noexcept {
    const std::uint32_t entry = entries[in.bits & (kEntries - 1)];
    in.bits >>= entry & 63u;
    in.have -= entry & 63u;
    auto pair = static_cast<std::uint16_t>(entry >> 16);
    if ((entry & kEntryEscapes) != 0) [[unlikely]] {
      in.fill();
      pair = static_cast<std::uint16_t>(in.take(2 * kRawUpperBits));
      in.fill();
    }
    std::memcpy(out, &pair, sizeof(pair));
  }
};

}  // namespace

PairBits bits_of_pair(std::uint8_t code, std::uint32_t a, std::uint32_t b) noexcept {
  const auto& words = codes()[code - 1u].words;
  if (a < kWordUppers && b < kWordUppers && words[kWordUppers * a + b].length > 0) return words[kWordUppers * a + b];
  const PairBits escape = words[kEscape];
  return {escape.bits | (a | b << kRawUpperBits) << escape.length,
          static_cast<std::uint8_t>(escape.length + 2 * kRawUpperBits)};
}

bool read_uppers(std::span<const BlockMotion> blocks, std::span<const std::uint8_t> codes_and_padding,
                 std::span<std::uint8_t> uppers) noexcept {
  if (codes_and_padding.size() < kCodeHeads + kCodePadding) return false;
  std::uint32_t sizes[2];
  std::memcpy(sizes, codes_and_padding.data(), sizeof(sizes));
  const std::size_t left = codes_and_padding.size() - kCodeHeads - kCodePadding;
  if (sizes[0] > left || sizes[1] > left - sizes[0]) return false;
  const std::uint8_t* first = codes_and_padding.data() + kCodeHeads;
  const std::uint8_t* const ends[3] = {first + sizes[0], first + sizes[0] + sizes[1], first + left};
  AxisReader x{{first}}, y{{ends[0]}}, z{{ends[1]}};
  const auto& all = codes();
  std::uint8_t* out = uppers.data();
  for (std::size_t b = 0; b < blocks.size(); ++b, out += kBlockNumbers) {
    x.use(blocks[b].code[0], all);
    y.use(blocks[b].code[1], all);
    z.use(blocks[b].code[2], all);
    for (std::size_t i = 0; i < kBlockPoints; i += 8) {
      x.in.fill();
      y.in.fill();
      z.in.fill();
      for (std::size_t k = i; k < i + 8; k += 2) {
        x.read_pair(out + k);
        y.read_pair(out + kBlockPoints + k);
        z.read_pair(out + 2 * kBlockPoints + k);
      }
    }
    if (x.in.end() > ends[0] || y.in.end() > ends[1] || z.in.end() > ends[2]) return false;
  }
  return x.in.end() == ends[0] && y.in.end() == ends[1] && z.in.end() == ends[2];
}

}  // namespace sinew
