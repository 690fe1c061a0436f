// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

namespace sinew {

/// Decodes an attribute stream of version 1 (KHR_meshopt_compression, "Mode 0: attributes"). The meshoptimizer of
/// Debian 12 and Ubuntu 24.04 only decodes version 0.
/// eq    header 0xa1 | blocks of at most min(8192 / stride, 256) elements | padding | first element, channel modes. A
///       block stores, for each byte position of an element, the differences to the previous element in groups of 16
/// in    encoded   the whole stream
///       stride    bytes per element: a multiple of 4, at most 256
/// out   out       [count * stride], count > 0
/// err   false for a damaged stream: truncated, trailing bytes, or an unknown channel mode
/// cost  O(out), no allocation
bool decode_attribute_stream(std::span<const std::byte> encoded, std::size_t stride, std::span<std::byte> out) noexcept;

/// Undoes the filter COLOR in place (KHR_meshopt_compression, "Filter 4: color"): Y, Co, Cg and alpha of K bits become
/// RGBA of 8 or 16 bits. The highest set bit of alpha encodes K.
/// eq    r = y + co - cg,  g = y + cg,  b = y - co - cg, each scaled from K bits and rounded
/// in    component_bytes   1 or 2; `values` has four components per element
/// out   values outside [0, 1], which encoders do not write, are clamped
void decode_color_filter(std::span<std::byte> values, std::size_t component_bytes) noexcept;

}  // namespace sinew
