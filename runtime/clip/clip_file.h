// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/clip/clip.h"

namespace sinew {

/// Why a block of compiled clips is refused: the broken rule, the byte where it was found, and the case in words.
///
///     clip-magic      the block does not begin as such blocks do
///     clip-version    another version of the library wrote it: compile the clips again
///     clip-checksum   bytes have changed since it was written
///     clip-value      a number makes no sense where it is
///     clip-size       the block ends too early, or goes on after its end
struct ClipFileError {
  std::string rule;
  std::uint64_t offset = 0;
  std::string detail;
};

/// Compiled clips as one block of bytes for a file or for memory: no pointers, little-endian numbers, any alignment.
/// A head of kClipFileHead bytes (magic, version, size, checksum of the rest), then the clips one after another. Tables
/// that follow from others are not stored; load_clips makes them again.
/// cost O(bytes), allocates
std::vector<std::byte> save_clips(std::span<const Clip* const> clips);

/// The clips of such a block. They sample the same bits as those that were saved, on every machine.
/// Any bytes may be passed: what could make a sample read or write outside of its clip is refused, and memory stays
/// below 16 MiB and 64 times the block. A block that was altered and signed anew may still hold rotations without a
/// length, whose poses are NaN.
/// err  ClipFileError;  cost O(bytes), allocates
tl::expected<std::vector<Clip>, ClipFileError> load_clips(std::span<const std::byte> block);

/// Bytes that the tracks of a clip take in such a block, without its name and certificate.
std::size_t saved_bytes(const Clip& clip);

/// Whether a block begins as save_clips begins them.
bool looks_like_clips(std::span<const std::byte> block) noexcept;

inline constexpr std::uint32_t kClipFileVersion = 3;  ///< 2 had another checksum
inline constexpr std::size_t kClipFileHead = 32;

}  // namespace sinew
