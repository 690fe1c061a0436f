// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "importer/read/image_codec.h"

namespace sinew {

/// Size and type of an image of a kind that is recognised, but not decoded: KTX2 (KHR_texture_basisu) and DDS
/// (MSFT_texture_dds). A consumer shows a placeholder; a converter keeps the bytes.
/// out   nothing for other kinds, and where the header is cut off
/// cost  O(header)
std::optional<ImageHeader> probe_undecoded_image(std::span<const std::byte> encoded) noexcept;

}  // namespace sinew
