// SPDX-License-Identifier: MIT
#include "importer/read/image_webp.h"

#include <webp/decode.h>

namespace sinew {
namespace {

using Bytes = std::span<const std::byte>;

const unsigned char* webp_data(Bytes bytes) noexcept { return reinterpret_cast<const unsigned char*>(bytes.data()); }

}  // namespace

std::optional<ImageHeader> probe_webp(Bytes encoded) {
  int width = 0, height = 0;
  if (WebPGetInfo(webp_data(encoded), encoded.size(), &width, &height) == 0) return std::nullopt;
  return ImageHeader{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), "image/webp"};
}

tl::expected<std::vector<std::uint8_t>, std::string> decode_webp(Bytes encoded, const ImageHeader& size) {
  std::vector<std::uint8_t> rgba(4 * size.pixels());
  if (WebPDecodeRGBAInto(webp_data(encoded), encoded.size(), rgba.data(), rgba.size(),
                         static_cast<int>(4 * size.width)) == nullptr)
    return tl::make_unexpected("its WebP data is damaged");
  return rgba;
}

}  // namespace sinew
