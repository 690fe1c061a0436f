// SPDX-License-Identifier: MIT
#include "importer/ktx2/basis_bits.h"

namespace sinew {
namespace {

constexpr unsigned kLengthSymbols = 21;

/// Order in which the lengths of the code of lengths are stored.
constexpr std::uint8_t kLengthOrder[kLengthSymbols] = {17, 18, 19, 20, 0,  8, 7,  9, 6,  10, 5,
                                                       11, 4,  12, 3,  13, 2, 14, 1, 15, 16};

/// Symbols 17 to 20 of a code of lengths: runs of zeros or of the length before.
struct Run {
  std::uint8_t extra_bits, least;
  bool of_zeros;
};
constexpr Run kRuns[] = {{3, 3, true}, {7, 11, true}, {2, 3, false}, {7, 7, false}};

}  // namespace

std::optional<HuffmanCode> HuffmanCode::make(std::span<const std::uint8_t> lengths) {
  HuffmanCode out;
  for (const std::uint8_t length : lengths) ++out.count_[length];
  out.count_[0] = 0;
  std::uint32_t room = 1, begin = 0;
  std::array<std::uint32_t, kLongest + 1> place{};
  for (unsigned length = 1; length <= kLongest; ++length) {
    room <<= 1;
    if (out.count_[length] > room) return std::nullopt;
    room -= out.count_[length];
    place[length] = begin;
    begin += out.count_[length];
  }
  out.symbols_.resize(begin);
  for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol)
    if (lengths[symbol] != 0) out.symbols_[place[lengths[symbol]]++] = static_cast<std::uint16_t>(symbol);
  return out;
}

std::optional<HuffmanCode> HuffmanCode::read(BasisBits& bits) {
  const std::uint32_t symbol_count = bits.take(14), stored = bits.take(5);
  if (stored > kLengthSymbols) return std::nullopt;
  if (symbol_count == 0) return HuffmanCode{};
  std::array<std::uint8_t, kLengthSymbols> length_lengths{};
  for (std::uint32_t i = 0; i < stored; ++i) length_lengths[kLengthOrder[i]] = static_cast<std::uint8_t>(bits.take(3));
  const auto length_code = make(length_lengths);
  if (!length_code) return std::nullopt;

  std::vector<std::uint8_t> lengths;
  lengths.reserve(symbol_count);
  while (lengths.size() < symbol_count) {
    const std::uint32_t symbol = length_code->next(bits);
    if (symbol == kNone || bits.overrun()) return std::nullopt;
    if (symbol <= kLongest) {
      lengths.push_back(static_cast<std::uint8_t>(symbol));
      continue;
    }
    const Run& run = kRuns[symbol - kLongest - 1];
    const std::uint32_t count = run.least + bits.take(run.extra_bits);
    if (!run.of_zeros && (lengths.empty() || lengths.back() == 0)) return std::nullopt;
    if (count > symbol_count - lengths.size()) return std::nullopt;
    lengths.insert(lengths.end(), count, run.of_zeros ? std::uint8_t{0} : lengths.back());
  }
  return make(lengths);
}

std::uint32_t HuffmanCode::next(BasisBits& bits) const noexcept {
  std::uint32_t code = 0, first = 0, begin = 0;  // first code of this length, and the place of its symbol
  for (unsigned length = 1; length <= kLongest; ++length) {
    code = code << 1 | bits.take(1);
    first <<= 1;
    if (code - first < count_[length]) return symbols_[begin + code - first];
    begin += count_[length];
    first += count_[length];
  }
  return kNone;
}

}  // namespace sinew
