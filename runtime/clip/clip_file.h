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

/// Why a block of compiled clips is refused: the broken rule, the byte at which it was found, and the case in words.
///
///     clip-magic      it does not begin as such a block does           clip-checksum  bytes have changed since it was
///     written clip-version    it was written by another version                clip-value     a number makes no sense
///     where it is clip-size       it ends too early, or goes on after its end
struct ClipFileError {
  std::string rule;
  std::uint64_t offset = 0;
  std::string detail;
};

/// Compiled clips as one block of bytes that can be written to a file or lie anywhere in memory: it has no pointers,
/// and little-endian numbers. A head of kClipFileHead bytes (magic, version, size, checksum of the rest) is followed by
/// the clips one after another. Tables that follow from others are not stored but made again. cost O(bytes), allocates
std::vector<std::byte> save_clips(std::span<const Clip* const> clips);

/// The clips of such a block. They sample the same bits as those that were saved, on every machine.
/// Any bytes are welcome: what could make a sample read or write outside of its clip is refused, and memory stays below
/// a small multiple of the block. err  see ClipFileError      cost O(bytes), allocates
tl::expected<std::vector<Clip>, ClipFileError> load_clips(std::span<const std::byte> block);

/// What the tracks of a clip take in such a block, without its name and certificate.
std::size_t saved_bytes(const Clip& clip);

/// Whether a block begins as save_clips begins them.
bool looks_like_clips(std::span<const std::byte> block) noexcept;

inline constexpr std::uint32_t kClipFileVersion = 2;
inline constexpr std::size_t kClipFileHead = 32;

}  // namespace sinew
