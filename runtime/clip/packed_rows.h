// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/shared_array.h"
#include "runtime/clip/packed_keys.h"

namespace sinew {

/// Packed tracks in the layout that sample_clip reads. Each track is a lane. Each key is a row of bits, padded to a
/// whole byte. A row is ordered by groups of four lanes, then by slot (a stored component), then by lane, lowest bit
/// first. So one load of sixteen bytes contains a component of four lanes. A byte shuffle moves the four bytes around
/// each number into its lane, and a mask removes the bits of others. The number is not shifted down: `step` is divided
/// instead.
///
/// Slots of vectors are their components. For a rotation with a derived component (PackedTrack), w takes the slot of
/// that component, and slot 3 is empty. Slot 3 is stored only if a track in the block has no derived component.
///
/// Tables are [slot][lane], with some entries after the last one, since vectors may read past the last lane.
struct PackedRows {
  enum Kind : std::uint8_t {
    swapped = 1,     ///< a track has w in the slot of another component
    no_derived = 2,  ///< a track has no derived component
  };

  std::uint32_t row_bytes = 0;
  std::uint32_t slot_count = 0;           ///< stored components per lane: 1, 3 or 4
  std::vector<std::uint16_t> first_byte;  ///< [slot][group of four lanes] where its sixteen bytes begin in a row
  std::array<bool, 4> shares_bytes{};     ///< [slot] its numbers lie in the sixteen bytes of the previous slot
  std::vector<std::uint8_t> byte;         ///< byte in which a number begins, relative to first_byte
  std::vector<std::uint32_t> mask;        ///< the bits of the number in the four bytes from there
  std::vector<std::uint16_t> step;        ///< upper half of a float: the value of the lowest bit of these four bytes
  std::vector<float> low;
  std::vector<std::uint8_t> derived;  ///< [lane] rotations only: the derived component
  std::vector<std::uint8_t> kinds;    ///< [group of sixteen lanes] rotations only: bits of Kind
  std::vector<std::uint8_t> power;    ///< [key] rotations only: power of slerp_series.h for the arcs to the next key;
                                      ///< a single entry if all are kUsualSlerpPower
  SharedArray<std::uint8_t> bits;     ///< [key][row_bytes], plus kReadAhead bytes

  bool empty() const noexcept { return mask.empty(); }
  std::size_t power_at(std::size_t key) const noexcept { return power[std::min(key, power.size() - 1)]; }
  std::size_t byte_size() const noexcept {
    return first_byte.size() * sizeof(std::uint16_t) + byte.size() + mask.size() * sizeof(std::uint32_t) +
           step.size() * sizeof(std::uint16_t) + low.size() * sizeof(float) + derived.size() + kinds.size() +
           power.size() + bits.size();
  }
};

/// Most lanes of one block, so that 16 bits can address every byte of a row.
inline constexpr std::size_t kMostPackedLanes = 1024;
static_assert(kMostPackedLanes * PackedTrack::kMostKeyBits < 65536);
inline constexpr std::size_t kReadAhead = 16;

/// Arranges packed tracks as the lanes of a block.
/// in   tracks  of one property, at most kMostPackedLanes, all with `key_count` keys
PackedRows packed_rows(std::span<const PackedTrack> tracks, std::size_t key_count);

/// As above, from numbers in the order of files (in_lane_order).
/// in   tracks  their `numbers` are not used     bits[key_count][row bytes]
PackedRows packed_rows(std::span<const PackedTrack> tracks, std::span<const std::uint8_t> bits, std::size_t key_count);

/// Bytes of a row.
std::size_t packed_row_bytes(std::span<const PackedTrack> tracks) noexcept;

/// One lane as a PackedTrack without `numbers`.
PackedTrack packed_range(const PackedRows& rows, std::size_t lanes, std::size_t lane);
/// One lane as pack_keys made it.
PackedTrack packed_lane(const PackedRows& rows, std::size_t lanes, std::size_t lane, std::size_t key_count);

/// All rows in the order of files: by lane, then by component.
/// out  [key_count][row bytes]
std::vector<std::uint8_t> in_lane_order(const PackedRows& rows, std::size_t lanes, std::size_t key_count);

}  // namespace sinew
