// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "importer/read/image_codec.h"

namespace sinew {

/// Reads size and type of a WebP image.
/// out   empty if it is not a WebP file or its header is damaged
/// cost  O(header)
std::optional<ImageHeader> probe_webp(std::span<const std::byte> encoded);

/// Decodes to RGBA with 8 bits per channel, top row first, straight alpha, by libwebp.
/// in    size   result of probe_webp
/// out   [4 * width * height]
/// err   a message for users
tl::expected<std::vector<std::uint8_t>, std::string> decode_webp(std::span<const std::byte> encoded,
                                                                 const ImageHeader& size);

}  // namespace sinew
