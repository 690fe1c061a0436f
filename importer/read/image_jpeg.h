// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "importer/read/image_codec.h"

namespace sinew {

/// Reads size and type of a JPEG image.
/// out   empty if it is not a JPEG file or its header is damaged
/// cost  O(header)
std::optional<ImageHeader> probe_jpeg(std::span<const std::byte> encoded);

/// Decodes to RGBA with 8 bits per channel, top row first, straight alpha, by libjpeg-turbo.
/// in    size   result of probe_jpeg
/// out   [4 * width * height]
/// err   a message for users
tl::expected<std::vector<std::uint8_t>, std::string> decode_jpeg(std::span<const std::byte> encoded,
                                                                 const ImageHeader& size);

}  // namespace sinew
