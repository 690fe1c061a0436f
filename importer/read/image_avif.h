// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "importer/read/image_codec.h"

namespace sinew {

/// Reads size and type of an AVIF image. Decoding uses libavif on one thread; for sequences it reads the still image.
/// Applies the stream's colour matrix, but no profiles, transfer curves, rotation or mirroring, as for other formats.
/// out   empty if it is not an AVIF file or is damaged
/// cost  O(header)
std::optional<ImageHeader> probe_avif(std::span<const std::byte> encoded);

/// Decodes to RGBA with 8 bits per channel, top row first, straight alpha.
/// in    size   result of probe_avif; streams with more pixels are refused before decoding
/// out   [4 * width * height]
/// err   a message for users
tl::expected<std::vector<std::uint8_t>, std::string> decode_avif(std::span<const std::byte> encoded,
                                                                 const ImageHeader& size);

}  // namespace sinew
