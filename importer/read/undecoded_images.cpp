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

/// Four bytes, the least significant first.   in   at + 4 <= bytes.size()
std::uint32_t little(Bytes bytes, std::size_t at) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return value;
}

/// Four bytes, the most significant first.   in   at + 4 <= bytes.size()
std::uint32_t big(Bytes bytes, std::size_t at) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return value;
}

/// eq   12 bytes of identifier, vkFormat, typeSize, pixelWidth, pixelHeight   (KTX 2.0, "Header"). A texture of one
///      dimension has height 0
std::optional<ImageHeader> ktx2(Bytes bytes) noexcept {
  if (!has(bytes, 0, "\xabKTX 20\xbb\r\n\x1a\n"sv) || bytes.size() < 28) return std::nullopt;
  return ImageHeader{little(bytes, 20), std::max(little(bytes, 24), 1u), "image/ktx2", false};
}

/// eq   "DDS ", size of the header, flags, height, width   (DDS_HEADER)
std::optional<ImageHeader> dds(Bytes bytes) noexcept {
  if (!has(bytes, 0, "DDS "sv) || bytes.size() < 20) return std::nullopt;
  return ImageHeader{little(bytes, 16), little(bytes, 12), "image/vnd-ms.dds", false};
}

/// eq   a box "ftyp" of brand avif or avis, and in the box "meta" a property "ispe": version, width, height
///      (ISO/IEC 23008-12)
std::optional<ImageHeader> avif(Bytes bytes) noexcept {
  constexpr std::size_t kHead = 4096, kAfterName = 12;
  if (!has(bytes, 4, "ftypavif"sv) && !has(bytes, 4, "ftypavis"sv)) return std::nullopt;
  for (std::size_t at = 16; at + 4 + kAfterName <= std::min(bytes.size(), kHead); ++at)
    if (has(bytes, at, "ispe"sv)) return ImageHeader{big(bytes, at + 8), big(bytes, at + 12), "image/avif", false};
  return std::nullopt;
}

}  // namespace

std::optional<ImageHeader> probe_undecoded_image(Bytes encoded) noexcept {
  if (const auto header = ktx2(encoded)) return header;
  if (const auto header = dds(encoded)) return header;
  return avif(encoded);
}

}  // namespace sinew
