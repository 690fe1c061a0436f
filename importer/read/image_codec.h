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
  bool is_decoded = true;  ///< decode_image() can decode this kind

  std::uint64_t pixels() const noexcept { return std::uint64_t{width} * height; }
};

/// Size and type of an encoded image from its first bytes, without decoding. PNG, JPEG, WebP, AVIF and the kinds that
/// are recognised but not decoded (undecoded_images.h) are told apart by content, not by name.
/// err   a sentence for people
/// cost  O(header)
tl::expected<ImageHeader, std::string> probe_image(std::span<const std::byte> encoded);

/// Decodes an image to RGBA with 8 bits a channel, rows from the top. 16-bit channels are reduced; missing channels are
/// filled (grey to red, green and blue; opaque).
/// in    encoded   an image that probe_image accepts and calls decoded
/// out   [4 * width * height]
/// err   a sentence for people
/// cost  O(pixels)
tl::expected<std::vector<std::uint8_t>, std::string> decode_image(std::span<const std::byte> encoded);

}  // namespace sinew
