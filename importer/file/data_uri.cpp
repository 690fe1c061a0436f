// SPDX-License-Identifier: MIT
#include "importer/file/data_uri.h"

#include <array>
#include <cstdint>

namespace sinew {
namespace {

constexpr std::uint8_t kNoDigit = 255;

constexpr std::array<std::uint8_t, 256> kDigits = [] {
  std::array<std::uint8_t, 256> digits{};
  digits.fill(kNoDigit);
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    digits[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  return digits;
}();

std::optional<std::vector<std::byte>> decode_base64(std::string_view text) {
  for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  unsigned bit_count = 0;
  for (const char c : text) {
    const std::uint8_t digit = kDigits[static_cast<unsigned char>(c)];
    if (digit == kNoDigit) return std::nullopt;
    bits = (bits << 6 | digit) & 0xffffffu;
    bit_count += 6;
    if (bit_count < 8) continue;
    bit_count -= 8;
    bytes.push_back(static_cast<std::byte>(bits >> bit_count & 0xffu));
  }
  return bytes;
}

}  // namespace

bool is_data_uri(std::string_view uri) noexcept { return uri.starts_with("data:"); }

std::optional<DataUri> decode_data_uri(std::string_view uri) {
  if (!is_data_uri(uri)) return std::nullopt;
  uri.remove_prefix(5);
  const auto comma = uri.find(',');
  if (comma == uri.npos) return std::nullopt;
  std::string_view media = uri.substr(0, comma);
  if (!media.ends_with(";base64")) return std::nullopt;
  media.remove_suffix(7);
  auto bytes = decode_base64(uri.substr(comma + 1));
  if (!bytes) return std::nullopt;
  return DataUri{std::string(media.substr(0, media.find(';'))), std::move(*bytes)};
}

}  // namespace sinew
