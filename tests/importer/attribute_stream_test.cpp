// SPDX-License-Identifier: MIT
#include "importer/decode/attribute_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <vector>

#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using Blob = std::vector<std::byte>;

/// A plain encoder, written from the text of KHR_meshopt_compression. The test chooses the control mode of each byte
/// position.
class Encoder {
 public:
  Encoder(std::size_t stride, std::vector<std::uint8_t> modes) : stride_(stride), modes_(std::move(modes)) {}

  Blob encode(const Blob& values, unsigned control) {
    put(0xa1);
    const std::size_t most = std::min(8192 / stride_ & ~std::size_t{15}, std::size_t{256});
    std::vector<std::uint8_t> last(stride_, 3);  // the first element, too, is stored as a difference
    const std::vector<std::uint8_t> baseline = last;
    for (std::size_t at = 0; at < values.size(); at += most * stride_)
      put_block(values, at, std::min(most, (values.size() - at) / stride_), last, control);
    const std::size_t tail = stride_ + stride_ / 4;
    for (std::size_t i = tail; i < 24; ++i) put(0);
    for (const std::uint8_t b : baseline) put(b);
    for (const std::uint8_t m : modes_) put(m);
    return std::move(out_);
  }

 private:
  void put(unsigned b) { out_.push_back(static_cast<std::byte>(b & 0xff)); }

  /// A little-endian unsigned integer of `size` bytes.
  static std::uint32_t load(const std::uint8_t* at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t b = size; b-- > 0;) value = value << 8 | at[b];
    return value;
  }

  static std::uint32_t zigzag(std::uint32_t v, std::size_t size) {
    const std::uint32_t sign = 1u << (8 * size - 1), twice = v << 1;
    return (v & sign) != 0 ? ~twice : twice;
  }

  /// Differences of one element to the last one, byte by byte, in the mode of each channel.
  std::vector<std::uint8_t> differences(const std::vector<std::uint8_t>& now, const std::vector<std::uint8_t>& last) {
    std::vector<std::uint8_t> out(stride_);
    for (std::size_t c = 0; c < stride_ / 4; ++c) {
      const std::size_t size = (modes_[c] & 15) == 0 ? 1 : (modes_[c] & 15) == 1 ? 2 : 4;
      for (std::size_t b = 4 * c; b < 4 * c + 4; b += size) {
        const std::uint32_t a = load(&now[b], size), p = load(&last[b], size);
        const std::uint32_t d = size == 4 ? std::rotl(a ^ p, modes_[c] >> 4) : zigzag(a - p, size);
        for (std::size_t i = 0; i < size; ++i) out[b + i] = static_cast<std::uint8_t>(d >> (8 * i));
      }
    }
    return out;
  }

  void put_block(const Blob& values, std::size_t at, std::size_t count, std::vector<std::uint8_t>& last,
                 unsigned control) {
    std::vector<std::vector<std::uint8_t>> planes(stride_, std::vector<std::uint8_t>((count + 15) / 16 * 16, 0));
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<std::uint8_t> now(stride_);
      std::memcpy(now.data(), values.data() + at + i * stride_, stride_);
      const auto d = differences(now, last);
      for (std::size_t b = 0; b < stride_; ++b) planes[b][i] = d[b];
      last = now;
    }
    const auto all_zero = [](const auto& p) { return std::all_of(p.begin(), p.end(), [](auto v) { return v == 0; }); };
    std::vector<unsigned> controls(stride_);
    for (std::size_t b = 0; b < stride_; ++b) controls[b] = control == 2 && !all_zero(planes[b]) ? 3 : control;
    for (std::size_t b = 0; b < stride_; b += 4)
      put(controls[b] | controls[b + 1] << 2 | controls[b + 2] << 4 | controls[b + 3] << 6);
    for (std::size_t b = 0; b < stride_; ++b) put_plane(planes[b], count, controls[b]);
  }

  void put_plane(const std::vector<std::uint8_t>& plane, std::size_t count, unsigned control) {
    if (control == 2) return;
    if (control == 3) {
      for (std::size_t i = 0; i < count; ++i) put(plane[i]);
      return;
    }
    constexpr unsigned kBits[2][4] = {{0, 1, 2, 4}, {1, 2, 4, 8}};
    const std::size_t groups = plane.size() / 16;
    std::vector<unsigned> modes(groups);
    for (std::size_t g = 0; g < groups; ++g) {
      modes[g] = static_cast<unsigned>(g + 1) % 4;  // each bit width in turn
      const bool zero = std::all_of(&plane[16 * g], &plane[16 * g] + 16, [](auto v) { return v == 0; });
      if (kBits[control][modes[g]] == 0 && !zero) modes[g] = 3;
    }
    for (std::size_t g = 0; g < groups; g += 4) {
      unsigned header = 0;
      for (std::size_t i = g; i < std::min(g + 4, groups); ++i) header |= modes[i] << (2 * (i - g));
      put(header);
    }
    for (std::size_t g = 0; g < groups; ++g) put_group(&plane[16 * g], kBits[control][modes[g]]);
  }

  void put_group(const std::uint8_t* d, unsigned bits) {
    if (bits == 0) return;
    const unsigned escape = (1u << bits) - 1;
    std::vector<unsigned> packed(2 * bits, 0), whole;
    for (unsigned i = 0; i < 16; ++i) {
      const unsigned per_byte = 8 / bits, place = i % per_byte;
      const bool large = bits < 8 && d[i] >= escape;
      if (large) whole.push_back(d[i]);
      packed[i / per_byte] |= (large ? escape : d[i]) << (bits == 1 ? place : 8 - bits * (place + 1));
    }
    for (const unsigned b : packed) put(b);
    for (const unsigned b : whole) put(b);
  }

  std::size_t stride_;
  std::vector<std::uint8_t> modes_;
  Blob out_;
};

Blob some_values(std::size_t count, std::size_t stride) {
  test::FixedRandom random(11);
  Blob values(count * stride);
  for (std::size_t i = 0; i < values.size(); ++i)  // some bytes change slowly, some at random, some never
    values[i] = static_cast<std::byte>(i % 3 == 0 ? i / stride / 5 : i % 3 == 1 ? random.below(256) : 9);
  return values;
}

Blob from_hex(std::string_view hex) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  Blob out;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    out.push_back(static_cast<std::byte>(digit(hex[i]) * 16 + digit(hex[i + 1])));
  return out;
}

TEST(attribute_stream, gives_back_what_a_plain_encoder_wrote_in_every_mode) {
  for (const std::size_t stride : {4u, 8u, 12u, 64u, 256u})
    for (const std::size_t count : {1u, 15u, 16u, 33u, 300u})
      for (const unsigned control : {0u, 1u, 2u, 3u})
        for (const int mode_bits : {0x00, 0x01, 0x02, 0x72, 0xf2}) {
          const auto mode = static_cast<std::uint8_t>(mode_bits);
          SCOPED_TRACE(testing::Message() << stride << ' ' << count << ' ' << control << ' ' << int(mode));
          std::vector<std::uint8_t> modes(stride / 4, 0);
          for (std::size_t c = 0; c < modes.size(); c += 2) modes[c] = mode;
          const Blob values = some_values(count, stride);
          Blob out(values.size());
          ASSERT_TRUE(decode_attribute_stream(Encoder(stride, modes).encode(values, control), stride, out));
          EXPECT_EQ(out, values);
        }
}

/// These streams were written by meshoptimizer 1.3, the library that defined the format.
TEST(attribute_stream, reads_streams_of_the_library_that_defined_them) {
  Blob bytes(12);
  ASSERT_TRUE(decode_attribute_stream(
      from_hex("a1550006000808000600080800060008080006000808000000000000000000000000000000000000000102030400"), 4,
      bytes));
  for (std::size_t i = 0; i < bytes.size(); ++i) EXPECT_EQ(std::to_integer<std::size_t>(bytes[i]), i + 1);

  constexpr std::string_view kCounters =
      "a1b77800585858585858585858585858585858585858585858585858585858585858585858585858585858152aaaaaaaaaaaaaaaaaaa"
      "0000000105090d1115191d2125292d3135393d4145494d5155595d6165696d7175797d8185898d9195990110001000808000008080c0"
      "c0602070b0b010f81818f86c6c2c1c3c4cccbcd6d676aefe8686feae76d6026f1a06ffaffbfaf4c5f21e36217019391c5f4f262e263f"
      "21720ffd1f7f9d00000e03063f00000000000000000000000000000000ffff0000a0c10152";
  Blob mixed(40 * 8);
  ASSERT_TRUE(decode_attribute_stream(from_hex(kCounters), 8, mixed));
  for (unsigned i = 0; i < 40; ++i) {
    std::array<std::uint16_t, 2> counters;
    float ramp = 0;
    std::memcpy(counters.data(), mixed.data() + 8 * i, 4);
    std::memcpy(&ramp, mixed.data() + 8 * i + 4, 4);
    EXPECT_EQ(counters[0], i * 300);
    EXPECT_EQ(counters[1], 65535 - i * i);
    EXPECT_EQ(ramp, 1.5f * float(i * i) - 20);
  }
}

TEST(attribute_stream, refuses_what_is_cut_longer_or_unknown) {
  const Blob values = some_values(70, 8);
  const Blob stream = Encoder(8, {1, 2}).encode(values, 1);
  Blob out(values.size());
  for (std::size_t size = 0; size < stream.size(); ++size) {
    Blob cut(stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(decode_attribute_stream(cut, 8, out)) << size;
  }
  Blob longer = stream;
  longer.insert(longer.begin() + 40, std::byte{0});
  EXPECT_FALSE(decode_attribute_stream(longer, 8, out));
  for (const unsigned mode : {0x03, 0x0f, 0x10, 0x21}) {
    Blob unknown = stream;
    unknown.back() = static_cast<std::byte>(mode);
    EXPECT_FALSE(decode_attribute_stream(unknown, 8, out)) << mode;
  }
  Blob other = stream;
  other[0] = std::byte{0xa2};
  EXPECT_FALSE(decode_attribute_stream(other, 8, out));
  EXPECT_FALSE(decode_attribute_stream(stream, 6, out));
  EXPECT_FALSE(decode_attribute_stream(stream, 0, out));
}

TEST(attribute_stream, refuses_a_stream_without_its_last_block) {
  const Blob values(300 * 4, std::byte{3});  // equal to the element before the first, so all differences are zero
  Blob stream = Encoder(4, {0}).encode(values, 2), out(values.size());
  ASSERT_EQ(stream.size(), 1u + 2 + 24) << "two blocks of one byte each";
  EXPECT_TRUE(decode_attribute_stream(stream, 4, out));
  stream.erase(stream.begin() + 2);
  EXPECT_FALSE(decode_attribute_stream(stream, 4, out));
}

TEST(attribute_stream, survives_any_byte_changed) {
  test::FixedRandom random(5);
  const Blob stream = Encoder(12, {0, 1, 0x32}).encode(some_values(50, 12), 0);
  for (int i = 0; i < 20000; ++i) {
    Blob damaged = stream, out(50 * 12);
    damaged[random.below(static_cast<std::uint32_t>(damaged.size()))] = static_cast<std::byte>(random.below(256));
    decode_attribute_stream(damaged, 12, out);
  }
}

TEST(color_filter, gives_colors_back_within_the_bits_they_were_stored_in) {
  const float colors[] = {1, 0, 0, 1, 0, 1, 0, 0.5f, 0, 0, 1, 0, 0.5f, 0.25f, 0.75f, 1};
  Blob bytes = from_hex("407fc1ff7f007fc04081c08070e1d0ff");  // 8 bits
  decode_color_filter(bytes, 1);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(std::to_integer<int>(bytes[i]), 255 * colors[i], 1.5f) << i;
  Blob words = from_hex("0004ff0701fcff0fff070000ff07000c000401f800fc0008000701fe00fdff0f");  // 12 bits in 16
  decode_color_filter(words, 2);
  for (std::size_t i = 0; i < 16; ++i) {
    std::uint16_t word = 0;
    std::memcpy(&word, words.data() + 2 * i, 2);
    EXPECT_NEAR(word, 65535 * colors[i], 65535.0f / 4095 * 2) << i;
  }
}

TEST(color_filter, clamps_what_no_encoder_writes) {
  Blob bytes = from_hex(
      "ff7f7f00"
      "7f7f80ff");
  decode_color_filter(bytes, 1);
  EXPECT_EQ(bytes, from_hex("00000000"
                            "ff0080ff"))
      << "no bit says what 1 is; red above 1 and green below 0";
}

}  // namespace
}  // namespace sinew
