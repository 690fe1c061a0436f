// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "importer/read/image_codec.h"

namespace sinew {

/// AVIF, by libavif on one thread. Of a sequence the still image is read. Colours are those that the stream's matrix
/// gives; profiles, transfer curves, rotation and mirroring of the container are not applied, as with other kinds.
/// out   nothing for what is no AVIF file, or a damaged one
/// cost  O(header)
std::optional<ImageHeader> probe_avif(std::span<const std::byte> encoded);

/// Decodes to RGBA with 8 bits a channel, rows from the top; colours are not multiplied by alpha.
/// in    size   that probe_avif gave; streams that hold more pixels are refused before they are decoded
/// out   [4 * width * height]
/// err   a sentence for people
tl::expected<std::vector<std::uint8_t>, std::string> decode_avif(std::span<const std::byte> encoded,
                                                                 const ImageHeader& size);

}  // namespace sinew
