// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/upload/mip_chain.h"

namespace sinew::viewer {

/// A rip map: the image scaled by all 2^-i x 2^-j, packed into one image of twice the width and height. Each level
/// averages pairs of texels along one axis; an odd last column or row is dropped. Colours and alpha are averaged as in
/// mip_chain, and each level is rounded once.
/// eq   level (i, j) is max(w >> i, 1) x max(h >> j, 1) texels, from texel (2 w - 2 (w >> i), 2 h - 2 (h >> j)) on; i
///      <= log2 w, j <= log2 h
/// in   rgba[4 * width * height], width and height at least 1
/// cost 4 times the memory of the image; O(pixels)
MipLevel rip_map(std::span<const std::uint8_t> rgba, std::uint32_t width, std::uint32_t height, const TexelUse& use);

}  // namespace sinew::viewer
