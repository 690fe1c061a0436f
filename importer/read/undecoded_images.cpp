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

/// eq   12 bytes of identifier, vkFormat, typeSize, pixelWidth, pixelHeight   (KTX 2.0, "Header"). A 1D texture has
///      height 0
std::optional<ImageHeader> ktx2(Bytes bytes) noexcept {
  if (!has(bytes, 0, "\xabKTX 20\xbb\r\n\x1a\n"sv) || bytes.size() < 28) return std::nullopt;
  return ImageHeader{little(bytes, 20), std::max(little(bytes, 24), 1u), "image/ktx2", false};
}

/// eq   "DDS ", size of the header, flags, height, width   (DDS_HEADER)
std::optional<ImageHeader> dds(Bytes bytes) noexcept {
  if (!has(bytes, 0, "DDS "sv) || bytes.size() < 20) return std::nullopt;
  return ImageHeader{little(bytes, 16), little(bytes, 12), "image/vnd-ms.dds", false};
}

}  // namespace

std::optional<ImageHeader> probe_undecoded_image(Bytes encoded) noexcept {
  if (const auto header = ktx2(encoded)) return header;
  return dds(encoded);
}

}  // namespace sinew
