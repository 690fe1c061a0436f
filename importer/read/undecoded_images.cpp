// SPDX-License-Identifier: MIT
#include "importer/read/undecoded_images.h"

#include <algorithm>
#include <string_view>

namespace sinew {
namespace {

using Bytes = std::span<const std::byte>;
using namespace std::literals;

bool has(Bytes bytes, std::size_t at, std::string_view text) noexcept {
  if (at > bytes.size() || text.size() > bytes.size() - at) return false;
  return std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char c, std::byte b) { return static_cast<std::byte>(c) == b; });
}

/// Reads a little-endian 32-bit number.   in   at + 4 <= bytes.size()
std::uint32_t little(Bytes bytes, std::size_t at) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return value;
}

/// eq   "DDS ", size of the header, flags, height, width   (DDS_HEADER)
std::optional<ImageHeader> dds(Bytes bytes) noexcept {
  if (!has(bytes, 0, "DDS "sv) || bytes.size() < 20) return std::nullopt;
  return ImageHeader{little(bytes, 16), little(bytes, 12), "image/vnd-ms.dds", false};
}

}  // namespace

std::optional<ImageHeader> probe_undecoded_image(Bytes encoded) noexcept { return dds(encoded); }

}  // namespace sinew
