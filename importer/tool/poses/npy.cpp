// SPDX-License-Identifier: MIT
#include "importer/tool/poses/npy.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <functional>
#include <numeric>

#include <fmt/format.h>

namespace sinew::tool {
namespace {

static_assert(std::endian::native == std::endian::little);

/// The code points of UTF-8 text.
std::u32string code_points(std::string_view text) {
  constexpr char32_t kReplacement = 0xfffd;
  std::u32string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
    char32_t point = length == 1 ? first : first & (0xffu >> (length + 1));
    bool is_whole = length > 0 && i + length <= text.size();
    for (std::size_t k = 1; is_whole && k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      is_whole = next >> 6 == 2;
      point = point << 6 | (next & 0x3f);
    }
    is_whole = is_whole && point <= 0x10ffff && (point < 0xd800 || point > 0xdfff);
    out += is_whole ? point : kReplacement;
    i += is_whole ? length : 1;
  }
  return out;
}

std::string shape_text(const std::vector<std::size_t>& shape) {
  return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

}  // namespace

std::uint64_t NpyArray::byte_size() const {
  std::uint64_t item = 0;
  std::from_chars(type.data() + 2, type.data() + type.size(), item);
  if (type[1] == 'U') item *= sizeof(char32_t);
  return std::accumulate(shape.begin(), shape.end(), item, std::multiplies<>());
}

std::string npy_head(const NpyArray& array) {
  std::string facts =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", array.type, shape_text(array.shape));
  constexpr std::size_t kPrefix = 10, kAligned = 64;
  facts.resize((kPrefix + facts.size() + 1 + kAligned - 1) / kAligned * kAligned - kPrefix - 1, ' ');
  facts += '\n';
  std::string out("\x93NUMPY\x01\x00", 8);
  out += static_cast<char>(facts.size() & 0xff);
  out += static_cast<char>(facts.size() >> 8);
  return out + facts;
}

std::size_t text_width(std::span<const std::string> texts) {
  std::size_t width = 1;
  for (const std::string& text : texts) width = std::max(width, code_points(text).size());
  return width;
}

std::string text_type(std::size_t width) { return fmt::format("<U{}", width); }

std::string text_entry(std::string_view text, std::size_t width) {
  std::u32string points = code_points(text);
  points.resize(width, U'\0');
  return {reinterpret_cast<const char*>(points.data()), points.size() * sizeof(char32_t)};
}

}  // namespace sinew::tool
