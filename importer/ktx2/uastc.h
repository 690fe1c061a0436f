// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace sinew {

constexpr std::size_t kUastcBlockBytes = 16;

/// Decodes a UASTC LDR block of 4 x 4 texels. Each of its 19 modes is a subset of ASTC: endpoints of up to 3 subsets of
/// texels, blended by a weight for each texel.
/// source   Basis Universal, "UASTC LDR 4x4 Texture Specification"; Khronos Data Format Specification, "ASTC"
///          (endpoint unquantization, partition patterns, weight application)
/// eq       c = ((257 e0) * (64 - w) + (257 e1) * w + 32) / 64 / 256
/// in       block   16 bytes
/// out      rgba    16 texels, row by row
/// err      false for the reserved mode and for a pattern that does not exist; rgba is unchanged
bool decode_uastc_block(std::span<const std::byte, kUastcBlockBytes> block, std::span<std::uint8_t, 64> rgba) noexcept;

}  // namespace sinew
