// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace sinew::viewer {

/// A PNG file in memory, 8 bits RGBA; empty when the sizes do not fit or memory ran out.
std::vector<unsigned char> encode_png(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height);

}  // namespace sinew::viewer
