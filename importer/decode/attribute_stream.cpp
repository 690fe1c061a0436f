// SPDX-License-Identifier: MIT
#include "importer/decode/attribute_stream.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

namespace sinew {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::size_t kGroup = 16;           ///< differences per packed group
constexpr std::size_t kMostElements = 256;   ///< elements per block
constexpr std::size_t kBlockBytes = 8192;    ///< decoded bytes per block
constexpr std::size_t kSmallestTail = 24;    ///< bytes at the end of every stream, at least
constexpr std::size_t kChannelBytes = 4;     ///< bytes of an element that share a mode
constexpr std::size_t kLargestStride = 256;  ///< bytes per element, at most
constexpr std::uint8_t kVersion = 0xa1;

/// Storage of one byte position in a block.
enum Control : unsigned { narrow, wide, all_zero, verbatim };

/// Bits of a packed difference, [control of the byte position][two header bits of the group].
constexpr std::array<std::array<unsigned, 4>, 2> kBits{{{0, 1, 2, 4}, {1, 2, 4, 8}}};

using Plane = std::array<std::uint8_t, kMostElements>;  ///< one byte position of all elements in a block

unsigned number(std::byte b) noexcept { return std::to_integer<unsigned>(b); }

class Reader {
 public:
  explicit Reader(Bytes bytes) : rest_(bytes) {}

  std::optional<Bytes> take(std::size_t size) noexcept {
    if (size > rest_.size()) return std::nullopt;
    const Bytes taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }
  bool at_end() const noexcept { return rest_.empty(); }

 private:
  Bytes rest_;
};

/// Extracts packed difference `i` of a group. With one bit each, the first is in the lowest bit; with two or four bits,
/// in the highest.
unsigned packed(Bytes bytes, unsigned bits, std::size_t i) noexcept {
  const std::size_t per_byte = 8 / bits, place = i % per_byte;
  const std::size_t shift = bits == 1 ? place : 8 - bits - place * bits;
  return number(bytes[i / per_byte]) >> shift & ((1u << bits) - 1);
}

/// Reads one group. A difference with all bits set is an escape: the real value is a byte after the group.
bool read_group(Reader& in, unsigned bits, std::uint8_t* out) noexcept {
  if (bits == 0) {
    std::fill_n(out, kGroup, std::uint8_t{0});
    return true;
  }
  const auto bytes = in.take(kGroup * bits / 8);
  if (!bytes) return false;
  if (bits == 8) {
    std::memcpy(out, bytes->data(), kGroup);
    return true;
  }
  const unsigned escape = (1u << bits) - 1;
  for (std::size_t i = 0; i < kGroup; ++i) {
    unsigned value = packed(*bytes, bits, i);
    if (value == escape) {
      const auto whole = in.take(1);
      if (!whole) return false;
      value = number(whole->front());
    }
    out[i] = static_cast<std::uint8_t>(value);
  }
  return true;
}

/// Reads the differences of one byte position of a block with `count` elements.
bool read_plane(Reader& in, unsigned control, std::size_t count, Plane& out) noexcept {
  if (control == all_zero) {
    out.fill(0);
    return true;
  }
  if (control == verbatim) {
    const auto bytes = in.take(count);
    if (bytes) std::memcpy(out.data(), bytes->data(), count);
    return bytes.has_value();
  }
  const std::size_t groups = (count + kGroup - 1) / kGroup;
  const auto header = in.take((groups + 3) / 4);
  if (!header) return false;
  for (std::size_t g = 0; g < groups; ++g) {
    const unsigned mode = number((*header)[g / 4]) >> (g % 4 * 2) & 3;
    if (!read_group(in, kBits[control][mode], out.data() + g * kGroup)) return false;
  }
  return true;
}

/// Decodes a zigzag-coded difference (sign in the lowest bit).
template <class T>
T unzigzag(T v) noexcept {
  return static_cast<T>((v & 1) != 0 ? ~(v >> 1) : v >> 1);
}

/// Decodes integer differences of type T at byte `first` of the channel, by prefix sums.
template <class T>
void add_differences(const std::array<Plane, kChannelBytes>& planes, std::size_t first, std::size_t count,
                     std::size_t stride, std::uint8_t* last, std::byte* out) noexcept {
  T value = 0;
  for (std::size_t b = sizeof(T); b-- > 0;) value = static_cast<T>(std::uint32_t{value} << 8 | last[first + b]);
  for (std::size_t i = 0; i < count; ++i) {
    T difference = 0;
    for (std::size_t b = sizeof(T); b-- > 0;)
      difference = static_cast<T>(std::uint32_t{difference} << 8 | planes[first + b][i]);
    value = static_cast<T>(value + unzigzag(difference));
    for (std::size_t b = 0; b < sizeof(T); ++b)
      out[i * stride + first + b] = static_cast<std::byte>(value >> (8 * b) & 0xff);
  }
  for (std::size_t b = 0; b < sizeof(T); ++b) last[first + b] = static_cast<std::uint8_t>(value >> (8 * b));
}

/// Decodes XOR differences of 32-bit numbers, which the encoder rotated left by `rotation` bits.
void flip_differences(const std::array<Plane, kChannelBytes>& planes, int rotation, std::size_t count,
                      std::size_t stride, std::uint8_t* last, std::byte* out) noexcept {
  std::uint32_t value = 0;
  for (std::size_t b = kChannelBytes; b-- > 0;) value = value << 8 | last[b];
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t difference = 0;
    for (std::size_t b = kChannelBytes; b-- > 0;) difference = difference << 8 | planes[b][i];
    value ^= std::rotr(difference, rotation);
    for (std::size_t b = 0; b < kChannelBytes; ++b)
      out[i * stride + b] = static_cast<std::byte>(value >> (8 * b) & 0xff);
  }
  for (std::size_t b = 0; b < kChannelBytes; ++b) last[b] = static_cast<std::uint8_t>(value >> (8 * b));
}

/// True for valid channel modes: the low 4 bits are the kind of difference; only kind 2 (XOR) uses the high 4 bits
/// (rotation).
bool is_known_mode(std::byte mode) noexcept {
  const unsigned kind = number(mode) & 15, rotation = number(mode) >> 4;
  return kind == 2 || (kind < 2 && rotation == 0);
}

void restore(const std::array<Plane, kChannelBytes>& planes, std::byte mode, std::size_t count, std::size_t stride,
             std::uint8_t* last, std::byte* out) noexcept {
  switch (number(mode) & 15) {
    case 0:
      for (std::size_t b = 0; b < kChannelBytes; ++b)
        add_differences<std::uint8_t>(planes, b, count, stride, last, out);
      return;
    case 1:
      for (std::size_t b = 0; b < kChannelBytes; b += 2)
        add_differences<std::uint16_t>(planes, b, count, stride, last, out);
      return;
    default: return flip_differences(planes, static_cast<int>(number(mode) >> 4), count, stride, last, out);
  }
}

/// Decodes one block.   in/out   last   the element before the block, then the last one of the block
bool read_block(Reader& in, Bytes modes, std::size_t stride, std::size_t count, std::uint8_t* last,
                std::byte* out) noexcept {
  const auto controls = in.take(stride / kChannelBytes);
  if (!controls) return false;
  std::array<Plane, kChannelBytes> planes;
  for (std::size_t channel = 0; channel < stride / kChannelBytes; ++channel) {
    const unsigned control = number((*controls)[channel]);
    for (std::size_t b = 0; b < kChannelBytes; ++b)
      if (!read_plane(in, control >> (2 * b) & 3, count, planes[b])) return false;
    const std::size_t first = channel * kChannelBytes;
    restore(planes, modes[channel], count, stride, last + first, out + first);
  }
  return true;
}

/// Loads a component as an unsigned little-endian number of 8 or 16 bits.
unsigned load(const std::byte* at, std::size_t bytes) noexcept {
  return bytes == 1 ? number(at[0]) : number(at[0]) | number(at[1]) << 8;
}

int load_signed(const std::byte* at, std::size_t bytes) noexcept {
  const unsigned value = load(at, bytes);
  return bytes == 1 ? static_cast<std::int8_t>(value) : static_cast<std::int16_t>(value);
}

}  // namespace

bool decode_attribute_stream(Bytes encoded, std::size_t stride, std::span<std::byte> out) noexcept {
  if (stride == 0 || stride > kLargestStride || stride % kChannelBytes != 0 || out.size() % stride != 0) return false;
  const std::size_t tail = stride + stride / kChannelBytes;
  const std::size_t padded_tail = std::max(tail, kSmallestTail);
  if (encoded.size() < 1 + padded_tail || number(encoded.front()) != kVersion) return false;
  const Bytes modes = encoded.last(stride / kChannelBytes);
  if (!std::all_of(modes.begin(), modes.end(), is_known_mode)) return false;
  std::array<std::uint8_t, kLargestStride> last{};
  std::memcpy(last.data(), encoded.data() + encoded.size() - tail, stride);

  Reader in(encoded.subspan(1, encoded.size() - 1 - padded_tail));
  const std::size_t most = std::min(kBlockBytes / stride & ~std::size_t{15}, kMostElements);
  for (std::size_t left = out.size() / stride; left > 0;) {
    const std::size_t count = std::min(left, most);
    if (!read_block(in, modes, stride, count, last.data(), out.data() + out.size() - left * stride)) return false;
    left -= count;
  }
  return in.at_end();
}

void decode_color_filter(std::span<std::byte> values, std::size_t component_bytes) noexcept {
  const float largest = component_bytes == 1 ? 255.0f : 65535.0f;
  for (std::size_t at = 0; at + 4 * component_bytes <= values.size(); at += 4 * component_bytes) {
    std::byte* element = values.data() + at;
    const int y = static_cast<int>(load(element, component_bytes));
    const int co = load_signed(element + component_bytes, component_bytes);
    const int cg = load_signed(element + 2 * component_bytes, component_bytes);
    const unsigned alpha = load(element + 3 * component_bytes, component_bytes);
    const auto one = static_cast<int>((1u << std::bit_width(alpha)) - 1);  // largest value of K bits
    const int opacity = static_cast<int>(alpha) & one >> 1;                // without the marker bit that encodes K
    const float scale = one > 0 ? largest / static_cast<float>(one) : 0.0f;
    const int rgba[4] = {y + co - cg, y + cg, y - co - cg, opacity << 1 | (opacity & 1)};
    for (std::size_t c = 0; c < 4; ++c) {
      const float scaled = std::clamp(static_cast<float>(rgba[c]) * scale, 0.0f, largest);
      const auto rounded = static_cast<unsigned>(std::lround(scaled));
      for (std::size_t b = 0; b < component_bytes; ++b)
        element[c * component_bytes + b] = static_cast<std::byte>(rounded >> (8 * b) & 0xff);
    }
  }
}

}  // namespace sinew
