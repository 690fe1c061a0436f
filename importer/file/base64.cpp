// SPDX-License-Identifier: MIT
#include "importer/file/base64.h"

#include <array>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "importer/file/base64.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

/// Decodes blocks of 16 characters to 12 bytes each, and stores 4 bytes more behind each block.
/// in    text[size]   out[size / 4 * 3 + 4]
/// out   characters decoded: all whole blocks before the first character that is not in the alphabet
std::size_t decode_blocks(const char* text, std::size_t size, std::byte* out) {
  std::size_t done = 0;
#if HWY_TARGET != HWY_SCALAR
  const hn::Full128<std::int8_t> d;
  const hn::Full128<std::uint8_t> d8;
  const hn::Repartition<std::uint16_t, decltype(d)> d16;
  const hn::Repartition<std::uint32_t, decltype(d)> d32;
  alignas(16) constexpr std::uint8_t kFirstByteHighest[16] = {2, 1, 0, 6, 5, 4, 10, 9, 8, 14, 13, 12, 15, 15, 15, 15};
  const auto order = hn::Load(d8, kFirstByteHighest);
  const auto all = [&](char c) HWY_ATTR { return hn::Set(d, c); };
  const auto slash = all('/'), plus = all('+');
  for (; size - done >= 16; done += 16) {
    const auto c = hn::BitCast(d, hn::LoadU(d8, reinterpret_cast<const std::uint8_t*>(text) + done));
    // Characters beyond ASCII are negative: they fall into the last class, where only two characters are good.
    const auto lower = hn::Gt(c, all('a' - 1)), upper = hn::Gt(c, all('A' - 1)), digit = hn::Gt(c, all('0' - 1));
    const auto choose = [&](int of_lower, int of_upper, int of_digit, auto otherwise) HWY_ATTR {
      const auto number = [&](int n) HWY_ATTR { return hn::Set(d, static_cast<std::int8_t>(n)); };
      return hn::IfThenElse(
          lower, number(of_lower),
          hn::IfThenElse(upper, number(of_upper), hn::IfThenElse(digit, number(of_digit), otherwise)));
    };
    const auto is_slash = hn::Eq(c, slash);
    const auto last = choose('z', 'Z', '9', hn::IfThenElse(is_slash, slash, plus));
    const auto first = choose('a', 'A', '0', hn::IfThenElse(is_slash, slash, plus));
    if (!hn::AllFalse(d, hn::Or(hn::Lt(c, first), hn::Gt(c, last)))) break;
    const auto shift =
        choose(26 - 'a', -'A', 52 - '0',
               hn::IfThenElse(is_slash, hn::Set(d, std::int8_t{63 - '/'}), hn::Set(d, std::int8_t{62 - '+'})));
    // Four numbers of 6 bits become one of 24: the first number is the highest.
    const auto six = hn::BitCast(d16, hn::Add(c, shift));
    const auto twelve = hn::BitCast(
        d32, hn::Or(hn::ShiftLeft<6>(hn::And(six, hn::Set(d16, std::uint16_t{0x3f}))), hn::ShiftRight<8>(six)));
    const auto twenty_four =
        hn::Or(hn::ShiftLeft<12>(hn::And(twelve, hn::Set(d32, 0xfffu))), hn::ShiftRight<16>(twelve));
    hn::StoreU(hn::TableLookupBytes(hn::BitCast(d8, twenty_four), order), d8,
               reinterpret_cast<std::uint8_t*>(out) + done / 4 * 3);
  }
#else
  (void)text;
  (void)size;
  (void)out;
#endif
  return done;
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

HWY_EXPORT(decode_blocks);

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNoDigit = 255;

constexpr std::array<std::uint8_t, 256> kDigits = [] {
  std::array<std::uint8_t, 256> digits{};
  digits.fill(kNoDigit);
  for (std::size_t i = 0; i < kAlphabet.size(); ++i)
    digits[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
  return digits;
}();

/// Decodes character by character: the end of a text, and the block with a character that is not in the alphabet.
bool decode_rest(std::string_view text, std::byte* out) noexcept {
  std::uint32_t bits = 0;
  unsigned bit_count = 0;
  for (const char c : text) {
    const std::uint8_t digit = kDigits[static_cast<unsigned char>(c)];
    if (digit == kNoDigit) return false;
    bits = (bits << 6 | digit) & 0xffffffu;
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    *out++ = static_cast<std::byte>(bits >> bit_count & 0xffu);
  }
  return true;
}

}  // namespace

std::optional<std::vector<std::byte>> decode_base64(std::string_view text) {
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  constexpr std::size_t kStoredBehind = 4;
  const std::size_t size = text.size() / 4 * 3 + (text.size() % 4) * 3 / 4;
  std::vector<std::byte> bytes(size + kStoredBehind);
  const std::size_t done = HWY_DYNAMIC_DISPATCH(decode_blocks)(text.data(), text.size(), bytes.data());
  if (!decode_rest(text.substr(done), bytes.data() + done / 4 * 3)) return std::nullopt;
  bytes.resize(size);
  return bytes;
}

std::string encode_base64(std::string_view bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kAlphabet[group >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

}  // namespace sinew
#endif
