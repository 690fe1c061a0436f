// SPDX-License-Identifier: MIT
#include "importer/ktx2/uastc.h"

#include <algorithm>
#include <array>

namespace sinew {
namespace {

constexpr unsigned kModes = 19, kSolidMode = 8;

/// How the endpoints of a mode are stored: `bits` of their own, and a trit or quint (base 3 or 5) that they share.
struct EndpointRange {
  std::uint8_t bits, base;  ///< base: 1, 3 or 5
  std::uint8_t factor;      ///< C of ASTC, "Endpoint Unquantization"
  const char* spread;       ///< B of ASTC, highest bit first; letters are bits of the value
};
constexpr EndpointRange k12{2, 3, 93, "b000b0bb0"}, k16{4, 1, 0, ""}, k32{5, 1, 0, ""}, k40{3, 5, 26, "cb0000cbc"};
constexpr EndpointRange k48{4, 3, 22, "dcb000dcb"}, k160{5, 5, 6, "edcb0000e"}, k192{6, 3, 5, "fedcb000f"};
constexpr EndpointRange k256{8, 1, 0, ""};

/// Layout of a block: mode code, hints for transcoders, pattern, channel of the second weights, endpoints, weights.
struct Mode {
  std::uint8_t code, code_bits;
  std::uint8_t hint_bits;
  std::uint8_t subsets, planes;
  std::uint8_t channels;  ///< 2 = luminance and alpha, 3 = RGB, 4 = RGBA
  std::uint8_t weight_bits;
  EndpointRange range;
};
constexpr Mode kMode[kModes] = {
    {0x01, 4, 15, 1, 1, 3, 4, k192}, {0x35, 6, 15, 1, 1, 3, 2, k256}, {0x1d, 5, 15, 2, 1, 3, 3, k16},
    {0x03, 5, 15, 3, 1, 3, 2, k12},  {0x13, 5, 15, 2, 1, 3, 2, k40},  {0x0b, 5, 15, 1, 1, 3, 3, k256},
    {0x1b, 5, 15, 1, 2, 3, 2, k160}, {0x07, 5, 15, 2, 1, 3, 2, k40},  {0x17, 5, 0, 0, 0, 4, 0, k256},
    {0x0f, 5, 23, 2, 1, 4, 2, k16},  {0x02, 3, 17, 1, 1, 4, 4, k48},  {0x00, 2, 17, 1, 2, 4, 2, k48},
    {0x06, 3, 17, 1, 1, 4, 3, k192}, {0x1f, 5, 23, 1, 2, 4, 1, k256}, {0x0d, 5, 23, 1, 1, 4, 2, k256},
    {0x05, 7, 23, 1, 1, 2, 4, k256}, {0x15, 6, 23, 2, 1, 2, 2, k256}, {0x25, 6, 23, 1, 2, 2, 2, k256},
    {0x09, 4, 15, 1, 1, 3, 5, k32},
};

/// ASTC partition seeds of the patterns that BC7 has, too: of 2 subsets (modes 2, 4, 9, 16), of 3 (mode 3), and of 2
/// that are part of a BC7 pattern of 3 (mode 7).
constexpr std::uint16_t kSeeds2[] = {28, 20,  16,  29, 91,  9,   107, 72,  149, 204, 50,  114, 496, 17,  78,
                                     39, 252, 828, 43, 156, 116, 210, 476, 273, 684, 359, 246, 195, 694, 524};
constexpr std::uint16_t kSeeds3[] = {260, 74, 32, 156, 183, 15, 745, 0, 335, 902, 254};
constexpr std::uint16_t kSeeds2Of3[] = {36,  48,  61,  137, 161, 183, 226, 281, 302, 307,
                                        479, 495, 593, 594, 605, 799, 812, 988, 993};

struct Pattern {
  std::uint8_t subset[16]{};                    ///< subset of each texel
  std::uint8_t anchor[3] = {0xff, 0xff, 0xff};  ///< first texel of each subset, whose weight has no highest bit
};

/// Hash of ASTC, "Partition Pattern Generation" (hash52).
constexpr std::uint32_t pattern_hash(std::uint32_t p) {
  p ^= p >> 15;
  p *= 0xeede0891u;  // (2^4 + 1)(2^7 + 1)(2^17 - 1)
  p ^= p >> 5;
  p += p << 16;
  p ^= p >> 7;
  p ^= p >> 3;
  p ^= p << 6;
  p ^= p >> 17;
  return p;
}

/// ASTC, "Partition Pattern Generation", for blocks of fewer than 31 texels.
constexpr Pattern make_pattern(std::uint32_t seed, std::uint32_t subsets) {
  const std::uint32_t hash = pattern_hash(seed + (subsets - 1) * 1024);
  const auto nibble = [hash](unsigned shift) {
    const std::uint32_t value = hash >> shift & 15u;
    return value * value;
  };
  const unsigned by_seed = (seed & 2u) != 0 ? 4 : 5, by_count = subsets == 3 ? 6 : 5;
  const unsigned even = (seed & 1u) != 0 ? by_seed : by_count, odd = (seed & 1u) != 0 ? by_count : by_seed;
  Pattern out;
  for (unsigned t = 0; t < 16; ++t) {
    const std::uint32_t x = t % 4 * 2, y = t / 4 * 2;
    const auto plane = [&](unsigned shift_x, unsigned shift_y, unsigned offset) {
      return ((nibble(shift_x) >> even) * x + (nibble(shift_y) >> odd) * y + (hash >> offset)) & 63u;
    };
    const std::uint32_t a = plane(0, 4, 14), b = plane(8, 12, 10), c = subsets == 3 ? plane(16, 20, 6) : 0;
    const unsigned subset = a >= b && a >= c ? 0 : b >= c ? 1 : 2;
    out.subset[t] = static_cast<std::uint8_t>(subset);
    if (out.anchor[subset] == 0xff) out.anchor[subset] = static_cast<std::uint8_t>(t);
  }
  return out;
}

template <std::size_t N>
constexpr std::array<Pattern, N> make_patterns(const std::uint16_t (&seeds)[N], std::uint32_t subsets) {
  std::array<Pattern, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = make_pattern(seeds[i], subsets);
  return out;
}
constexpr auto kPatterns2 = make_patterns(kSeeds2, 2);
constexpr auto kPatterns3 = make_patterns(kSeeds3, 3);
constexpr auto kPatterns2Of3 = make_patterns(kSeeds2Of3, 2);
constexpr Pattern kOneSubset{{}, {0, 0xff, 0xff}};

/// The pattern of this index; null if there is none.
const Pattern* find_pattern(unsigned mode, unsigned index) {
  const std::span<const Pattern> patterns = mode == 3   ? std::span<const Pattern>(kPatterns3)
                                            : mode == 7 ? std::span<const Pattern>(kPatterns2Of3)
                                                        : std::span<const Pattern>(kPatterns2);
  return index < patterns.size() ? &patterns[index] : nullptr;
}

/// Weights of 1 to 5 bits (ASTC, "Weight Unquantization").
constexpr std::uint32_t weight_of(std::uint32_t value, unsigned bits) {
  std::uint32_t weight = 0;  // the bits repeated to 6
  for (int shift = 6 - static_cast<int>(bits); shift > -static_cast<int>(bits); shift -= static_cast<int>(bits))
    weight |= shift >= 0 ? value << shift : value >> -shift;
  return weight > 32 ? weight + 1 : weight;
}

/// ASTC, "Endpoint Unquantization".   in   digit   trit or quint
constexpr std::uint8_t endpoint_of(const EndpointRange& range, std::uint32_t value, std::uint32_t digit) {
  if (range.base == 1) {
    std::uint32_t out = 0;
    for (int shift = 8 - range.bits; shift > -range.bits; shift -= range.bits)
      out |= shift >= 0 ? value << shift : value >> -shift;
    return static_cast<std::uint8_t>(out);
  }
  std::uint32_t spread = 0;
  for (unsigned i = 0; i < 9; ++i)
    spread = spread << 1 | (range.spread[i] == '0' ? 0u : value >> (range.spread[i] - 'a') & 1u);
  const std::uint32_t low = (value & 1u) != 0 ? 511 : 0;
  const std::uint32_t mixed = (digit * range.factor + spread) ^ low;
  return static_cast<std::uint8_t>((low & 0x80u) | mixed >> 2);
}

/// Takes fields of a block of 128 bits from its lowest bit up.
class BlockBits {
 public:
  explicit BlockBits(std::span<const std::byte, kUastcBlockBytes> block) {
    for (std::size_t i = 8; i-- > 0;) {
      low_ = low_ << 8 | std::to_integer<std::uint64_t>(block[i]);
      high_ = high_ << 8 | std::to_integer<std::uint64_t>(block[i + 8]);
    }
  }

  /// in   count < 64
  std::uint32_t take(unsigned count) {
    if (count == 0) return 0;
    const auto value = static_cast<std::uint32_t>(low_ & ((std::uint64_t{1} << count) - 1));
    low_ = low_ >> count | high_ << (64 - count);
    high_ >>= count;
    return value;
  }

  std::uint32_t peek() const { return static_cast<std::uint32_t>(low_); }

 private:
  std::uint64_t low_ = 0, high_ = 0;
};

unsigned mode_of(std::uint32_t bits) {
  const auto* mode = std::find_if(std::begin(kMode), std::end(kMode),
                                  [bits](const Mode& m) { return (bits & ((1u << m.code_bits) - 1u)) == m.code; });
  return static_cast<unsigned>(mode - kMode);
}

/// Endpoints in their order in the block: for each subset and channel the first, then the second.
using Endpoints = std::array<std::uint8_t, 18>;

Endpoints read_endpoints(const Mode& mode, BlockBits& bits) {
  constexpr std::uint8_t kTritBits[] = {0, 2, 4, 5, 7, 8}, kQuintBits[] = {0, 3, 5, 7};
  const EndpointRange& range = mode.range;
  const unsigned count = 2u * mode.channels * mode.subsets, bundle = range.base == 3 ? 5 : 3;
  std::array<std::uint8_t, 18> digits{};
  for (unsigned first = 0; range.base != 1 && first < count; first += bundle) {
    const unsigned size = std::min(bundle, count - first);
    std::uint32_t packed = bits.take(range.base == 3 ? kTritBits[size] : kQuintBits[size]);
    for (unsigned i = 0; i < size; ++i, packed /= range.base)
      digits[first + i] = static_cast<std::uint8_t>(packed % range.base);
  }
  Endpoints out{};
  for (unsigned i = 0; i < count; ++i) out[i] = endpoint_of(range, bits.take(range.bits), digits[i]);
  return out;
}

std::uint8_t mix(std::uint32_t first, std::uint32_t second, std::uint32_t weight) {
  return static_cast<std::uint8_t>((257 * first * (64 - weight) + 257 * second * weight + 32) >> 14);
}

}  // namespace

bool decode_uastc_block(std::span<const std::byte, kUastcBlockBytes> block, std::span<std::uint8_t, 64> rgba) noexcept {
  BlockBits bits(block);
  const unsigned index = mode_of(bits.peek());
  if (index == kModes) return false;
  const Mode& mode = kMode[index];
  bits.take(mode.code_bits);
  if (index == kSolidMode) {
    const std::uint32_t color = bits.take(32);
    for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = static_cast<std::uint8_t>(color >> 8 * (i % 4));
    return true;
  }
  bits.take(mode.hint_bits);
  const Pattern* pattern = mode.subsets == 1 ? &kOneSubset : find_pattern(index, bits.take(mode.subsets == 3 ? 4 : 5));
  if (pattern == nullptr) return false;
  const bool is_grey = mode.channels == 2;
  unsigned second_channel = 4;  // the channel that has weights of its own; 4 = none
  if (mode.planes == 2) second_channel = is_grey ? 3 : bits.take(2);

  const Endpoints endpoints = read_endpoints(mode, bits);
  for (unsigned t = 0; t < 16; ++t) {
    const unsigned subset = pattern->subset[t];
    const bool is_anchor = pattern->anchor[subset] == t;
    std::uint32_t weight[2];
    for (unsigned plane = 0; plane < mode.planes; ++plane)
      weight[plane] = weight_of(bits.take(mode.weight_bits - (is_anchor ? 1u : 0u)), mode.weight_bits);
    for (unsigned c = 0; c < 4; ++c) {
      const unsigned stored = is_grey ? c / 3 : c;
      const std::uint8_t* ends =
          &endpoints[2 * (subset * mode.channels + std::min<unsigned>(stored, mode.channels - 1u))];
      rgba[4 * t + c] = stored < mode.channels ? mix(ends[0], ends[1], weight[c == second_channel]) : std::uint8_t{255};
    }
  }
  return true;
}

}  // namespace sinew
