// SPDX-License-Identifier: MIT
// Layout of .sgeo files, shared by the encoder (importer/geometry_cache) and the decoder. Little-endian.
//
// - head       kGeometryFileHead bytes: magic, version, 0, size of head and directory, size of the file, checksum of
// the
//              directory
// - directory  meshes, streams, tables of frames, in the order in which geometry_cache.cpp reads them
// - frames     in the order of time; each holds one frame of every stream
//
// One frame of a stream has three sections. Each is stored as it is or compressed by zstd, whichever is smaller.
// - coarse     kinds, widths, shifts, upper bytes of offsets and matrices: planes of small numbers
// - fine       lowest bytes of offsets and matrices: close to random
// - payload    packed residuals
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
inline constexpr std::size_t kSections = 3;
inline constexpr std::size_t kSectionHeads = kSections * sizeof(std::uint32_t);

/// A block's kind is one byte: its BlockBase, a bit for the matrix and a bit for spreading residuals.
inline constexpr std::uint8_t kTurnsBit = 4, kSpreadsBit = 8;

/// Byte planes of the offsets above the lowest byte. The first byte of the coarse section says how many there are.
inline constexpr unsigned kMaxOffsetPlanes = 3;
inline constexpr std::uint8_t kMaxShift = 30;

/// Limit for one cache, so that sizes fit their types.
inline constexpr std::uint32_t kMaxPoints = 1u << 26;

/// Bytes of the packed residuals of these blocks.
inline std::size_t payload_bytes(std::span<const BlockMotion> blocks) noexcept {
  std::size_t bytes = 0;
  for (const BlockMotion& block : blocks)
    for (const std::uint8_t width : block.width) bytes += std::size_t{8} * width;
  return bytes;
}

}  // namespace sinew
