// SPDX-License-Identifier: MIT
// The numbers below are those of PKWARE's APPNOTE.TXT, sections 4.3.7 to 4.3.16 and 4.5.3, which describe zip files.
#include "importer/tool/poses/zip_records.h"

#include <cstddef>
#include <initializer_list>

namespace sinew::tool {
namespace {

constexpr std::uint64_t kInZip64 = 0xffffffff;  ///< value of a four-byte field whose number is in the longer field
constexpr std::uint64_t kManyInZip64 = 0xffff;

/// The lowest `Bytes` bytes of a number, lowest first.
template <std::size_t Bytes>
void put(std::string& out, std::uint64_t number) {
  for (std::size_t i = 0; i < Bytes; ++i) out += static_cast<char>(number >> (8 * i) & 0xff);
}

std::uint64_t short_field(std::uint64_t number) { return number < kInZip64 ? number : kInZip64; }

/// The extra field of ZIP64: the numbers that do not fit into four bytes. Empty if all fit.
std::string zip64_field(std::initializer_list<std::uint64_t> numbers) {
  std::string content, out;
  for (const std::uint64_t number : numbers)
    if (number >= kInZip64) put<8>(content, number);
  if (content.empty()) return out;
  put<2>(out, 0x0001);
  put<2>(out, content.size());
  return out + content;
}

std::uint64_t version_needed(const std::string& extra) { return extra.empty() ? 20 : 45; }

/// The fields that both headers of a file have: version, flags, method (stored), time, checksum, sizes.
void put_facts(std::string& out, std::uint32_t checksum, std::uint64_t size, std::size_t name_length,
               const std::string& extra) {
  constexpr std::uint64_t kFirstOfJanuary1980 = 0x21;
  put<2>(out, version_needed(extra));
  put<2>(out, 0);  // flags
  put<2>(out, 0);  // stored
  put<2>(out, 0);  // time of day
  put<2>(out, kFirstOfJanuary1980);
  put<4>(out, checksum);
  put<4>(out, short_field(size));  // compressed
  put<4>(out, short_field(size));
  put<2>(out, name_length);
  put<2>(out, extra.size());
}

}  // namespace

std::string zip_local_head(const std::string& name, std::uint32_t checksum, std::uint64_t size) {
  const std::string extra = zip64_field({size, size});
  std::string out;
  put<4>(out, 0x04034b50);
  put_facts(out, checksum, size, name.size(), extra);
  return out + name + extra;
}

std::string zip_directory_entry(const std::string& name, std::uint32_t checksum, std::uint64_t size, std::uint64_t at) {
  const std::string extra = zip64_field({size, size, at});
  std::string out;
  put<4>(out, 0x02014b50);
  put<2>(out, version_needed(extra));  // made by
  put_facts(out, checksum, size, name.size(), extra);
  put<2>(out, 0);  // comment
  put<2>(out, 0);  // disk
  put<2>(out, 0);  // attributes inside and outside
  put<4>(out, 0);
  put<4>(out, short_field(at));
  return out + name + extra;
}

std::string zip_ending(std::uint64_t count, std::uint64_t directory_at, std::uint64_t directory_size) {
  std::string out;
  const bool is_long = count >= kManyInZip64 || directory_at >= kInZip64 || directory_size >= kInZip64;
  if (is_long) {
    constexpr std::uint64_t kSizeBehindThisField = 44, kVersion = 45;
    put<4>(out, 0x06064b50);
    put<8>(out, kSizeBehindThisField);
    for (int i = 0; i < 2; ++i) put<2>(out, kVersion);
    put<8>(out, 0);  // disks
    for (int i = 0; i < 2; ++i) put<8>(out, count);
    put<8>(out, directory_size);
    put<8>(out, directory_at);
    put<4>(out, 0x07064b50);
    put<4>(out, 0);  // disk
    put<8>(out, directory_at + directory_size);
    put<4>(out, 1);  // disks
  }
  put<4>(out, 0x06054b50);
  put<4>(out, 0);  // disks
  for (int i = 0; i < 2; ++i) put<2>(out, is_long ? kManyInZip64 : count);
  put<4>(out, is_long ? kInZip64 : directory_size);
  put<4>(out, is_long ? kInZip64 : directory_at);
  put<2>(out, 0);  // comment
  return out;
}

}  // namespace sinew::tool
