// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/upload/mip_chain.h"

namespace sinew::viewer {

/// A rip map: the image at all sizes 2^-i x 2^-j, side by side in one image that is twice as wide and twice as high.
/// Each level is averaged from twice as many texels along one axis; a last column or row that is left over is dropped,
/// as by mip_chain. Colours and alpha are averaged as there, and each level is rounded once.
/// eq   level (i, j) is max(w >> i, 1) x max(h >> j, 1) texels, from texel (2 w - 2 (w >> i), 2 h - 2 (h >> j)) on;
///      i <= log2 w, j <= log2 h
/// in   rgba[4 * width * height], width and height at least 1
/// cost 4 times the memory of the image; O(pixels)
MipLevel rip_map(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, const TexelUse& use);

}  // namespace sinew::viewer
