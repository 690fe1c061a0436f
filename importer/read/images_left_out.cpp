// SPDX-License-Identifier: MIT
// Compiled instead of image_jpeg.cpp, image_webp.cpp and image_avif.cpp in builds without SINEW_IMAGE_CODECS. These
// formats are recognised, and probe_image() says why they cannot be read.
#include <algorithm>
#include <string_view>

#include "importer/read/image_avif.h"
#include "importer/read/image_jpeg.h"
#include "importer/read/image_webp.h"

namespace sinew {
namespace {

using Bytes = std::span<const std::byte>;
using Pixels = tl::expected<std::vector<std::uint8_t>, std::string>;

bool has_text(Bytes bytes, std::size_t at, std::string_view text) noexcept {
  if (at > bytes.size() || text.size() > bytes.size() - at) return false;
  return std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char c, std::byte b) { return static_cast<std::byte>(c) == b; });
}

std::optional<ImageHeader> header_left_out(bool recognised, const char* mime_type) {
  if (!recognised) return std::nullopt;
  return ImageHeader{.mime_type = mime_type, .is_decoded = false, .left_out = true};
}

Pixels no_codec() { return tl::make_unexpected("is of a format that this build cannot read"); }

}  // namespace

std::optional<ImageHeader> probe_jpeg(Bytes encoded) {
  return header_left_out(has_text(encoded, 0, "\xff\xd8"), "image/jpeg");
}
std::optional<ImageHeader> probe_webp(Bytes encoded) {
  return header_left_out(has_text(encoded, 0, "RIFF") && has_text(encoded, 8, "WEBP"), "image/webp");
}
std::optional<ImageHeader> probe_avif(Bytes encoded) {
  return header_left_out(has_text(encoded, 4, "ftypavif") || has_text(encoded, 4, "ftypavis"), "image/avif");
}

Pixels decode_jpeg(Bytes, const ImageHeader&) { return no_codec(); }
Pixels decode_webp(Bytes, const ImageHeader&) { return no_codec(); }
Pixels decode_avif(Bytes, const ImageHeader&) { return no_codec(); }

}  // namespace sinew
