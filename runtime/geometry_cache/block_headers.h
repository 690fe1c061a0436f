// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/geometry_cache/block_motion.h"

namespace sinew {

/// Motions of all blocks of a frame as byte planes, which general compressors pack well (geometry_format.h).
struct BlockHeaderBytes {
  std::vector<std::uint8_t> coarse, fine;
};
BlockHeaderBytes write_block_headers(std::span<const BlockMotion> blocks);

enum class FramePlace : std::uint8_t { key, second, later };

/// Reads the output of write_block_headers. Any bytes may be passed.
/// in   place   place of the frame in its segment. Blocks of a key frame are predicted in space, later ones in time.
///      The second frame may only use one earlier frame.
/// out  blocks  [blocks]
/// err  false: sizes that do not fit; kinds, shifts or widths that do not exist
bool read_block_headers(std::span<const std::uint8_t> coarse, std::span<const std::uint8_t> fine, FramePlace place,
                        std::span<BlockMotion> blocks) noexcept;

/// Largest sizes of the coarse and the fine section.
std::size_t most_coarse_bytes(std::size_t blocks) noexcept;
std::size_t most_fine_bytes(std::size_t blocks) noexcept;

}  // namespace sinew
