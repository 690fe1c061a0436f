// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/block_headers.h"

#include <algorithm>

#include "runtime/geometry_cache/geometry_format.h"

namespace sinew {
namespace {

std::uint32_t byte_of(std::uint32_t number, unsigned byte) { return number >> (8 * byte) & 0xffu; }

/// Offsets of key frames are stored as differences to the previous block, because consecutive blocks are near each
/// other.
std::vector<std::array<std::uint32_t, 3>> stored_offsets(std::span<const BlockMotion> blocks) {
  std::vector<std::array<std::uint32_t, 3>> stored;
  std::array<std::int32_t, 3> before{};
  for (const BlockMotion& block : blocks) {
    auto& s = stored.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
      s[axis] = zigzag(static_cast<std::int32_t>(static_cast<std::uint32_t>(block.offset[axis]) -
                                                 static_cast<std::uint32_t>(before[axis])));
    if (block.base == BlockBase::space) before = block.offset;
  }
  return stored;
}

bool may_follow(FramePlace place, BlockBase base) noexcept {
  if (place == FramePlace::key || base == BlockBase::space) return place == FramePlace::key && base == BlockBase::space;
  return place == FramePlace::later || base == BlockBase::last;
}

/// The byte planes of both sections. Byte `b` of plane `p` is at p * (bytes of a plane) + b.
struct Planes {
  const std::uint8_t *kinds, *widths, *upper_offsets, *shifts, *upper_matrices;  // planes of the coarse section
  const std::uint8_t *offsets, *matrices;                                        // planes of the fine section
  unsigned offset_planes;  // number of planes above the lowest byte
  std::size_t blocks, turning;
};

/// Finds the planes in the sections; false if the sizes do not fit.
bool find_planes(std::span<const std::uint8_t> coarse, std::span<const std::uint8_t> fine, std::size_t blocks,
                 Planes& out) noexcept {
  if (coarse.size() < 1 + blocks || coarse[0] > kMaxOffsetPlanes) return false;
  out.offset_planes = coarse[0];
  out.blocks = blocks;
  out.kinds = coarse.data() + 1;
  out.turning = static_cast<std::size_t>(
      std::count_if(out.kinds, out.kinds + blocks, [](std::uint8_t kind) { return (kind & kTurnsBit) != 0; }));
  out.widths = out.kinds + blocks;
  out.upper_offsets = out.widths + 3 * blocks;
  out.shifts = out.upper_offsets + 3 * out.offset_planes * blocks;
  out.upper_matrices = out.shifts + out.turning;
  out.offsets = fine.data();
  out.matrices = out.offsets + 3 * blocks;
  return coarse.size() == 1 + blocks * (4 + 3 * out.offset_planes) + 10 * out.turning &&
         fine.size() == 3 * blocks + 9 * out.turning;
}

std::uint32_t offset_at(const Planes& planes, std::size_t axis, std::size_t block) noexcept {
  std::uint32_t number = 0;
  for (unsigned p = 0; p < planes.offset_planes; ++p)
    number = number << 8 | planes.upper_offsets[(3 * p + axis) * planes.blocks + block];
  return number << 8 | planes.offsets[axis * planes.blocks + block];
}

}  // namespace

std::size_t most_coarse_bytes(std::size_t blocks) noexcept {
  return 1 + blocks * (1 + 3 + 3 * kMaxOffsetPlanes + 1 + 9);
}
std::size_t most_fine_bytes(std::size_t blocks) noexcept { return blocks * (3 + 9); }

BlockHeaderBytes write_block_headers(std::span<const BlockMotion> blocks) {
  BlockHeaderBytes out;
  const auto put = [](std::vector<std::uint8_t>& to, std::uint32_t byte) {
    to.push_back(static_cast<std::uint8_t>(byte));
  };
  const auto offsets = stored_offsets(blocks);
  std::uint32_t all = 0;
  for (const auto& offset : offsets) all |= offset[0] | offset[1] | offset[2];
  const unsigned offset_planes = all >= 1u << 24 ? 3 : all >= 1u << 16 ? 2 : all >= 1u << 8 ? 1 : 0;
  put(out.coarse, offset_planes);
  for (const BlockMotion& block : blocks)
    put(out.coarse,
        static_cast<std::uint32_t>(block.base) | (block.turns ? kTurnsBit : 0u) | (block.spreads ? kSpreadsBit : 0u));
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const BlockMotion& block : blocks) put(out.coarse, block.width[axis]);
  for (unsigned byte = offset_planes; byte > 0; --byte)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const auto& offset : offsets) put(out.coarse, byte_of(offset[axis], byte));
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const auto& offset : offsets) put(out.fine, byte_of(offset[axis], 0));
  for (const BlockMotion& block : blocks)
    if (block.turns) put(out.coarse, block.shift);
  for (std::size_t k = 0; k < 9; ++k)
    for (const BlockMotion& block : blocks) {
      if (!block.turns) continue;
      put(out.coarse, byte_of(zigzag(block.matrix[k]), 1));
      put(out.fine, byte_of(zigzag(block.matrix[k]), 0));
    }
  return out;
}

bool read_block_headers(std::span<const std::uint8_t> coarse, std::span<const std::uint8_t> fine, FramePlace place,
                        std::span<BlockMotion> blocks) noexcept {
  Planes planes;
  if (!find_planes(coarse, fine, blocks.size(), planes)) return false;
  bool sound = true;
  std::size_t turning = 0;
  std::array<std::uint32_t, 3> before{};
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    BlockMotion& block = blocks[b];
    const std::uint8_t kind = planes.kinds[b];
    block.base = static_cast<BlockBase>(kind & 3u);
    block.turns = (kind & kTurnsBit) != 0;
    block.spreads = (kind & kSpreadsBit) != 0;
    sound = sound && kind < 2 * kSpreadsBit && may_follow(place, block.base) &&
            !((block.turns || block.spreads) && block.base == BlockBase::space);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block.width[axis] = planes.widths[axis * blocks.size() + b];
      sound = sound && block.width[axis] <= kMaxWidth;
      const std::uint32_t offset = before[axis] + static_cast<std::uint32_t>(unzigzag(offset_at(planes, axis, b)));
      block.offset[axis] = static_cast<std::int32_t>(offset);
      if (block.base == BlockBase::space) before[axis] = offset;
    }
    block.shift = 0;
    if (!block.turns) continue;
    block.shift = planes.shifts[turning];
    sound = sound && block.shift <= kMaxShift;
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t at = k * planes.turning + turning;
      block.matrix[k] =
          static_cast<std::int16_t>(unzigzag(std::uint32_t{planes.upper_matrices[at]} << 8 | planes.matrices[at]));
    }
    ++turning;
  }
  return sound;
}

}  // namespace sinew
