// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace sinew {

struct ImageHeader {
  std::uint32_t width = 0, height = 0;
  const char* mime_type = "";
  bool is_decoded = true;  ///< decode_image() supports this format
  bool left_out = false;   ///< other builds support it; its size is not known

  std::uint64_t pixels() const noexcept { return std::uint64_t{width} * height; }
};

/// Size and format of an encoded image, from its first bytes. Detects PNG, JPEG, WebP, AVIF, KTX2 and the formats of
/// undecoded_images.h by content.
/// err   a message for users
/// cost  O(header)
tl::expected<ImageHeader, std::string> probe_image(std::span<const std::byte> encoded);

/// Decodes an image to RGBA with 8 bits per channel, top row first. Reduces 16-bit channels; expands grey to RGB and
/// missing alpha to opaque.
/// in    encoded   an image for which probe_image() returned is_decoded
/// out   [4 * width * height]
/// err   a message for users
/// cost  O(pixels)
tl::expected<std::vector<std::uint8_t>, std::string> decode_image(std::span<const std::byte> encoded);

}  // namespace sinew
