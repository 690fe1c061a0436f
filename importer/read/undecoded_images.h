// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "importer/read/image_codec.h"

namespace sinew {

/// Size and format of images that are recognised but not decoded: DDS (MSFT_texture_dds).
/// Viewers show a placeholder; converters keep the bytes.
/// out   empty for other formats and truncated headers
/// cost  O(header)
std::optional<ImageHeader> probe_undecoded_image(std::span<const std::byte> encoded) noexcept;

}  // namespace sinew
