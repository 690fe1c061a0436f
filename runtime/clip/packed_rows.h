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

/// Packed tracks side by side, as the lanes of sample_clip read them. A key is a row of bits that ends on a byte. Lanes
/// are in fours: a row has, for each four, the numbers of their first component, then those of the second and so on,
/// the lowest bit first. So sixteen bytes hold one component of four lanes, a byte shuffle puts the four bytes that
/// hold a number into each lane, and a mask leaves its bits. They stay where they are: the step is divided instead.
///
/// Rotations have the left-out component in slot 3 and w, where it is not left out, in the slot of that component; slot
/// 3 has numbers only where a track leaves none out.
///
/// Tables are [slot][lane], and go on to a multiple of kLanePadding lanes: vectors begin at multiples of their lanes.
struct PackedRows {
  enum Kind : std::uint8_t {
    swapped = 1,     ///< a track has w in another slot
    no_derived = 2,  ///< a track leaves out no component
  };

  std::uint32_t row_bytes = 0;
  std::uint32_t slot_count = 0;           ///< with numbers: 1, 3 or 4
  std::vector<std::uint16_t> first_byte;  ///< [slot][fours of lanes] in the row, of the sixteen that have the numbers
  std::array<bool, 4> shares_bytes{};     ///< [slot] those of the slot before have its numbers too, in all fours
  std::vector<std::uint8_t> byte;         ///< where a number begins, from there
  std::vector<std::uint32_t> mask;        ///< its bits in the four bytes that begin there
  std::vector<std::uint16_t> step;        ///< upper half of the float: what one in these four bytes stands for
  std::vector<float> low;
  std::vector<std::uint8_t> derived;  ///< [lane] of rotations: the component that is left out
  std::vector<std::uint8_t> kinds;    ///< [sixteens of lanes] of rotations
  std::vector<std::uint8_t> power;    ///< [key] of rotations: for their arcs to the next key (slerp_series.h); or one,
                                      ///< the usual, for all keys
  SharedArray<std::uint8_t> bits;     ///< [key][row_bytes], and kReadAhead more bytes

  bool empty() const noexcept { return mask.empty(); }
  std::size_t power_at(std::size_t key) const noexcept { return power[std::min(key, power.size() - 1)]; }
  std::size_t byte_size() const noexcept {
    return first_byte.size() * sizeof(std::uint16_t) + byte.size() + mask.size() * sizeof(std::uint32_t) +
           step.size() * sizeof(std::uint16_t) + low.size() * sizeof(float) + derived.size() + kinds.size() +
           power.size() + bits.size();
  }
};

/// Most lanes of one block, so that 16 bits number every byte of a row.
inline constexpr std::size_t kMostPackedLanes = 1024;
static_assert(kMostPackedLanes * PackedTrack::kMostKeyBits < 65536);
inline constexpr std::size_t kReadAhead = 16;

/// in   tracks  of one property, at most kMostPackedLanes, all with `key_count` keys
PackedRows packed_rows(std::span<const PackedTrack> tracks, std::size_t key_count);

/// The same from numbers as files have them (in_lane_order).
/// in   tracks  without numbers     bits[key_count][row bytes]
PackedRows packed_rows(std::span<const PackedTrack> tracks, std::span<const std::uint8_t> bits, std::size_t key_count);

/// Bytes of a row: all numbers of a key.
std::size_t packed_row_bytes(std::span<const PackedTrack> tracks) noexcept;

/// One lane of packed rows, as pack_keys made it, but without numbers.
PackedTrack packed_range(const PackedRows& rows, std::size_t lanes, std::size_t lane);
/// With numbers.
PackedTrack packed_lane(const PackedRows& rows, std::size_t lanes, std::size_t lane, std::size_t key_count);

/// All rows with the numbers in the order of lanes, each lane's components one after another.
/// out  [key_count][row bytes]
std::vector<std::uint8_t> in_lane_order(const PackedRows& rows, std::size_t lanes, std::size_t key_count);

}  // namespace sinew
