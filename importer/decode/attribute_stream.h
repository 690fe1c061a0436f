// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

namespace sinew {

/// Decodes an attribute stream of version 1 (KHR_meshopt_compression, "Mode 0: attributes"), which the library of
/// Debian 12 and Ubuntu 24.04 does not know. The library decodes version 0.
/// eq    header 0xa1 | blocks of at most min(8192 / stride, 256) elements | padding | first element, channel modes.
///       A block holds, for each byte of an element, the differences to the element before in groups of 16
/// in    encoded   the whole stream
///       stride    bytes of an element: a multiple of 4 up to 256
/// out   out       [count * stride], count > 0
/// err   false for a damaged stream: it ends early, has bytes left over, or an unknown channel mode
/// cost  O(out), no allocation
bool decode_attribute_stream(std::span<const std::byte> encoded, std::size_t stride, std::span<std::byte> out) noexcept;

/// Undoes the filter COLOR in place (KHR_meshopt_compression, "Filter 4: color"): Y, Co, Cg and alpha of K bits become
/// RGBA of 8 or 16 bits. The highest bit that is set in alpha says what K is.
/// eq    r = y + co - cg,  g = y + cg,  b = y - co - cg, each scaled from K bits and rounded
/// in    component_bytes   1 or 2; `values` holds four components an element
/// out   values outside [0, 1], which no encoder writes, are clamped
void decode_color_filter(std::span<std::byte> values, std::size_t component_bytes) noexcept;

}  // namespace sinew
