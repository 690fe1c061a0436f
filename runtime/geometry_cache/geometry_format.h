// SPDX-License-Identifier: MIT
// Layout of .sgeo files, shared by the encoder (importer/geometry_cache) and the decoder. Little-endian.
//
//   head       kGeometryFileHead bytes: magic, version, 0, bytes of head and directory together, bytes of the file,
//              checksum of the directory
//   directory  meshes, streams, tables of frames (geometry_cache.cpp reads it in its order)
//   frames     one after another, each the frames of all streams one after another
//
// A frame of a stream is four sections, each stored as it is or by zstd, whichever is smaller. Version 1 has no codes:
//   coarse     kinds, widths, shifts, upper bytes of offsets and matrices: planes of small numbers
//   fine       lowest bytes of offsets and matrices: close to random
//   payload    packed residuals, or the packed lower bits of coded ones
//   codes      prefix codes of the bits above them (residual_code.h); empty if no block has one
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/geometry_cache/block_motion.h"

namespace sinew {

inline constexpr char kGeometryMagic[8] = {'S', 'I', 'N', 'E', 'W', 'G', 'E', 'O'};

/// Bit of a section's size field: the section is packed by zstd.
inline constexpr std::uint32_t kStoredByZstd = 0x80000000u;
inline constexpr std::size_t kSections = 4;
constexpr std::size_t section_count(std::uint32_t version) noexcept { return version == 1 ? 3 : kSections; }
inline constexpr std::size_t kSectionHeads = kSections * sizeof(std::uint32_t);

/// Bit of a stream's kind, of version 2: its grid is centred.
inline constexpr std::uint8_t kCentredBit = 0x80;

/// A block's kind is one byte: its BlockBase, a bit for the matrix, one for spreading residuals and one for their
/// means.
inline constexpr std::uint8_t kTurnsBit = 4, kSpreadsBit = 8, kMeansBit = 16;

/// Byte planes of the offsets above the lowest byte. The first byte of the coarse section says how many there are.
inline constexpr unsigned kMaxOffsetPlanes = 3;
inline constexpr std::uint8_t kMaxShift = 30;

/// Limit for one cache, so that sizes fit their types.
inline constexpr std::uint32_t kMaxPoints = 1u << 26;

/// One byte holds a width and a code: widths without a code, then those of all codes.
constexpr std::uint8_t width_byte(std::uint8_t code, std::uint8_t width) noexcept {
  return static_cast<std::uint8_t>(code == 0 ? width : kMaxWidth + code + kResidualCodes * width);
}

/// Bytes of the packed residuals of these blocks.
inline std::size_t payload_bytes(std::span<const BlockMotion> blocks) noexcept {
  std::size_t bytes = 0;
  for (const BlockMotion& block : blocks)
    for (const std::uint8_t width : block.width) bytes += std::size_t{8} * width;
  return bytes;
}

inline bool have_codes(std::span<const BlockMotion> blocks) noexcept {
  for (const BlockMotion& block : blocks)
    if ((block.code[0] | block.code[1] | block.code[2]) != 0) return true;
  return false;
}

}  // namespace sinew
