// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/animation/track.h"

namespace sinew {

/// The keys of one track as integers: component c of a key is low[c] + step[c] * number. It takes width[c] bits, just
/// enough for the track's own range, and none where the component does not change.
///
/// Rotations may leave out the component that stays farthest from 0. It follows from the others: keys are unit, and q
/// and -q are the same rotation, so that the sign is chosen to make it positive in every key.
struct PackedTrack {
  static constexpr std::uint32_t kMostBits = 24;     ///< of a component: whole numbers that float holds
  static constexpr std::uint32_t kMostKeyBits = 56;  ///< of a key: found in eight bytes from any bit on
  static constexpr std::uint8_t kNoneDerived = 4;

  std::uint32_t components = 0;
  std::uint8_t derived = kNoneDerived;
  std::array<float, 4> low{}, step{};
  std::array<std::uint8_t, 4> width{};
  std::vector<std::uint32_t> numbers;  ///< [key][component]

  std::uint32_t bits_per_key() const noexcept { return std::uint32_t{width[0]} + width[1] + width[2] + width[3]; }
};

/// Packs the keys of a step or linear track so that none moves by more than `tolerance`: a length, or for rotations the
/// distance by which a point one unit from the axis moves, or a difference of weights.
/// out  nothing for curves, and where a component would take more than kMostBits or a key more than kMostKeyBits
std::optional<PackedTrack> pack_keys(const Vec3Track& track, double tolerance);
std::optional<PackedTrack> pack_keys(const QuatTrack& track, double tolerance);
std::optional<PackedTrack> pack_keys(const WeightTrack& track, std::uint32_t weight, double tolerance);

/// A key after rounding, by the arithmetic of the lanes: single multiplications and additions in float.
std::array<float, 4> unpack_key(const PackedTrack& track, std::size_t key) noexcept;

/// Packed tracks side by side. A key is a row of bits, each track's components one after another in the order of lanes,
/// the lowest bit first, and ends on a byte. Tables have kLanePadding more entries: lanes may read past the end.
struct PackedRows {
  std::uint32_t row_bytes = 0;
  std::vector<std::uint16_t> first_bit;  ///< [lane] in the row
  std::vector<std::uint8_t> width;       ///< [component][lane]
  std::vector<float> low, step;          ///< [component][lane]
  std::vector<std::uint8_t> derived;     ///< [lane] of rotations
  std::vector<std::uint8_t> bits;        ///< [key][row_bytes], and kReadAhead more bytes

  bool empty() const noexcept { return width.empty(); }
  std::size_t byte_size() const noexcept {
    return first_bit.size() * sizeof(std::uint16_t) + width.size() + (low.size() + step.size()) * sizeof(float) +
           derived.size() + bits.size();
  }
};

/// Most lanes of one block, so that 16 bits number every bit of a row.
inline constexpr std::size_t kMostPackedLanes = 1024;
static_assert(kMostPackedLanes * PackedTrack::kMostKeyBits < 65536);
inline constexpr std::size_t kReadAhead = sizeof(std::uint64_t);

/// Makes `first_bit` and `row_bytes` from the widths.
void place_bits(PackedRows& rows, std::size_t lanes, std::size_t components);

/// in   tracks  of one property, at most kMostPackedLanes, all with `key_count` keys
PackedRows packed_rows(std::span<const PackedTrack> tracks, std::size_t key_count);

/// One lane of packed rows, as pack_keys made it.
PackedTrack packed_lane(const PackedRows& rows, std::size_t lanes, std::size_t lane, std::size_t key_count);

}  // namespace sinew
