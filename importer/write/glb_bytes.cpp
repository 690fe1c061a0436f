// SPDX-License-Identifier: MIT
#include "importer/write/glb_bytes.h"

#include <cstdint>
#include <cstring>

namespace sinew::write {
namespace {

constexpr std::uint64_t kLargestGlb = 0xffffffffu;

constexpr std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

class Bytes {
 public:
  explicit Bytes(std::size_t size) { out.reserve(size); }

  void add_u32(std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::byte>(value >> shift & 0xffu));
  }

  void add_chunk(std::string_view type, std::span<const std::byte> data, std::byte filler) {
    add_u32(padded(data.size()));
    const auto letters = std::as_bytes(std::span(type));
    out.insert(out.end(), letters.begin(), letters.end());
    out.insert(out.end(), data.begin(), data.end());
    out.resize(padded(out.size()), filler);
  }

  std::vector<std::byte> out;
};

}  // namespace

std::optional<std::vector<std::byte>> glb_bytes(std::string_view json, std::span<const std::byte> bin) {
  const std::uint64_t length = 12 + 8 + padded(json.size()) + (bin.empty() ? 0 : 8 + padded(bin.size()));
  if (length > kLargestGlb) return std::nullopt;
  Bytes file(static_cast<std::size_t>(length));
  file.out.resize(4);
  std::memcpy(file.out.data(), "glTF", 4);
  file.add_u32(2);
  file.add_u32(static_cast<std::size_t>(length));
  file.add_chunk("JSON", std::as_bytes(std::span(json)), std::byte{' '});
  if (!bin.empty()) file.add_chunk(std::string_view("BIN\0", 4), bin, std::byte{0});
  return std::move(file.out);
}

}  // namespace sinew::write
