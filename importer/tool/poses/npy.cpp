// SPDX-License-Identifier: MIT
#include "importer/tool/poses/npy.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <limits>

#include <fmt/format.h>

namespace sinew::tool {
namespace {

static_assert(std::endian::native == std::endian::little);

/// The last `Bytes` bytes of a number, lowest first.
template <std::size_t Bytes>
void put(std::string& out, std::uint64_t number) {
  for (std::size_t i = 0; i < Bytes; ++i) out += static_cast<char>(number >> (8 * i) & 0xff);
}

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

/// What both headers of a file in a zip say about it: version, flags, method (stored), time, checksum, sizes.
void put_zip_facts(std::string& out, std::string_view content, std::size_t name_length) {
  constexpr std::uint64_t kVersion = 20, kFirstOfJanuary1980 = 0x21;
  put<2>(out, kVersion);
  put<2>(out, 0);  // flags
  put<2>(out, 0);  // stored
  put<2>(out, 0);  // time of day
  put<2>(out, kFirstOfJanuary1980);
  put<4>(out, crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size()));
  put<4>(out, content.size());  // compressed
  put<4>(out, content.size());
  put<2>(out, name_length);
  put<2>(out, 0);  // extra fields
}

}  // namespace

NpyArray text_array(std::string name, std::span<const std::string> texts) {
  std::vector<std::u32string> points;
  std::size_t widest = 1;
  for (const std::string& text : texts) widest = std::max(widest, points.emplace_back(code_points(text)).size());
  NpyArray out{std::move(name), fmt::format("<U{}", widest), {texts.size()}, {}};
  for (std::u32string& text : points) {
    text.resize(widest, U'\0');
    for (const char32_t point : text) put<4>(out.bytes, point);
  }
  return out;
}

std::string npy_file(const NpyArray& array) {
  std::string header =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", array.type, shape_text(array.shape));
  constexpr std::size_t kPrefix = 10, kAligned = 64;  // the data begin at a multiple of 64 bytes
  header.resize((kPrefix + header.size() + 1 + kAligned - 1) / kAligned * kAligned - kPrefix - 1, ' ');
  header += '\n';
  std::string out("\x93NUMPY\x01\x00", 8);
  put<2>(out, header.size());
  return out + header + array.bytes;
}

std::string npz_file(std::span<const NpyArray> arrays) {
  std::string out, directory;
  for (const NpyArray& array : arrays) {
    const std::string name = array.name + ".npy", content = npy_file(array);
    put<4>(directory, 0x02014b50);
    put<2>(directory, 20);  // made by
    put_zip_facts(directory, content, name.size());
    put<2>(directory, 0);  // comment
    put<2>(directory, 0);  // disk
    put<2>(directory, 0);  // attributes inside and outside
    put<4>(directory, 0);
    put<4>(directory, out.size());
    directory += name;
    put<4>(out, 0x04034b50);
    put_zip_facts(out, content, name.size());
    out += name + content;
  }
  const std::size_t directory_at = out.size();
  out += directory;
  put<4>(out, 0x06054b50);
  put<4>(out, 0);  // disks
  for (int i = 0; i < 2; ++i) put<2>(out, arrays.size());
  put<4>(out, directory.size());
  put<4>(out, directory_at);
  put<2>(out, 0);  // comment
  const bool fits = out.size() <= std::numeric_limits<std::uint32_t>::max() && arrays.size() < 0xffff;
  return fits ? out : std::string();
}

}  // namespace sinew::tool
