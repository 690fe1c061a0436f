// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace sinew {

struct Ktx2Size {
  std::uint32_t width = 0, height = 0;
};

/// Size of a KTX 2.0 file; empty for other files and for headers that are cut off.
/// eq     12 bytes of identifier, vkFormat, typeSize, pixelWidth, pixelHeight (KTX 2.0, "Header"). A 1D texture has
///        height 0, which counts as 1
/// cost   O(1)
std::optional<Ktx2Size> find_ktx2_size(std::span<const std::byte> encoded) noexcept;

/// Decodes the largest image of a KTX 2.0 file: ETC1S with BasisLZ, UASTC with or without zstd (KHR_texture_basisu),
/// and uncompressed formats of 1 to 4 channels with 8 bits. Smaller levels are left to the viewer.
/// in     encoded   a file for which find_ktx2_size() returned a size that is not too large for the caller
/// out    [4 * width * height] RGBA, top row first; red stands for all colors of one channel, blue is 0 with two
/// err    a message for users: the damaged part, or the format that is not decoded
/// cost   O(pixels)
tl::expected<std::vector<std::uint8_t>, std::string> decode_ktx2(std::span<const std::byte> encoded);

}  // namespace sinew
