// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "importer/geometry_cache/geometry_take.h"

namespace sinew {

/// One stream of a cache: what its directory says, and the bytes of its frames.
struct EncodedStream {
  GeometryStream info;
  std::vector<std::vector<std::byte>> frames;
};

/// Levels of zstd. In frames, 1 keeps to entropy coding: higher levels find matches that save nothing and cost time to
/// undo. The directory is read once.
inline constexpr int kFrameZstdLevel = 1, kDirectoryZstdLevel = 19;

/// Bytes as they are stored: by zstd where that saves an eighth or more, since it takes time to undo.
/// out  appended to `out`;   returns the size, with kStoredByZstd
std::uint32_t store_bytes(std::span<const std::uint8_t> bytes, std::vector<std::byte>& out,
                          int zstd_level = kFrameZstdLevel);

/// in   step      of the grid, in the unit of the values
///      reach     largest distance of a decoded value, in steps
/// cost some microseconds per point and frame
EncodedStream encode_stream(const TakeStream& stream, std::span<const std::uint32_t> triangles, float step,
                            double reach, std::uint32_t segment_frames);

}  // namespace sinew
