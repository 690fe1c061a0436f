// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "importer/geometry_cache/geometry_take.h"

namespace sinew {

/// An encoded stream of a cache: its directory entry, and the bytes of its frames.
struct EncodedStream {
  GeometryStream info;
  std::vector<std::vector<std::byte>> frames;
};

/// zstd levels. Frames use level 1, mostly entropy coding: matches of higher levels save nothing and cost decoding
/// time. The directory is decoded only once.
inline constexpr int kFrameZstdLevel = 1, kDirectoryZstdLevel = 19;

/// Stores bytes, compressed with zstd only if that saves at least 1/8, because decompression takes time.
/// out  appended to `out`;   returns the size, with kStoredByZstd
std::uint32_t store_bytes(std::span<const std::uint8_t> bytes, std::vector<std::byte>& out,
                          int zstd_level = kFrameZstdLevel);

/// Encodes one attribute of a mesh over all frames.
/// in   step      grid step, in the unit of the values
///      reach     largest error of a decoded value, in steps
/// cost some microseconds per point and frame
EncodedStream encode_stream(const TakeStream& stream, std::span<const std::uint32_t> triangles, float step,
                            double reach, std::uint32_t segment_frames);

}  // namespace sinew
