// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/base/api.h"
#include "runtime/clip/clip.h"

namespace sinew {

/// Why a block of compiled clips is refused: the broken rule, the offset of the byte, and a description.
///
///     clip-magic      the block does not begin with the magic number
///     clip-version    another version of the library wrote the block: compile the clips again
///     clip-checksum   bytes have changed since the block was written
///     clip-value      a number is out of its valid range
///     clip-size       the block ends too early, or bytes follow the last clip
struct ClipFileError {
  std::string rule;
  std::uint64_t offset = 0;
  std::string detail;
};

/// Serialises compiled clips into one block of bytes: no pointers, little-endian numbers, any alignment. The block has
/// a head of kClipFileHead bytes (magic, version, size, checksum of the rest), then the clips. Tables that can be
/// computed from other data are not stored; load_clips computes them.
/// cost O(bytes), allocates
SINEW_API std::vector<std::byte> save_clips(std::span<const Clip* const> clips);

/// Loads the clips of a block from save_clips. They sample the same bits as the saved clips, on every machine. Any
/// bytes may be passed. A block that could make sampling access memory outside of its clip is refused. Memory stays
/// below 16 MiB plus 64 times the block. A block that was altered and then given a new checksum may still contain
/// rotations of length zero, whose poses are NaN.
/// err  ClipFileError;  cost O(bytes), allocates
SINEW_API tl::expected<std::vector<Clip>, ClipFileError> load_clips(std::span<const std::byte> block);

/// Bytes that the tracks of a clip take in a block, without its name and certificate.
SINEW_API std::size_t saved_bytes(const Clip& clip);

/// True if the block begins with the magic number of save_clips.
SINEW_API bool looks_like_clips(std::span<const std::byte> block) noexcept;

inline constexpr std::uint32_t kClipFileVersion = 4;  ///< version 3 had no events and curves
inline constexpr std::size_t kClipFileHead = 32;

}  // namespace sinew
