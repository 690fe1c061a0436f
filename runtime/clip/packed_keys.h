// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
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
  static constexpr std::uint32_t kMostKeyBits = 56;  ///< of a key
  static constexpr float kLeastStep = 0x1p-100f;  ///< of a component with bits: lanes divide it by up to 128, exactly
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

/// The same of a rotation, normalised in double.
glm::quat unpack_rotation(const PackedTrack& track, std::size_t key) noexcept;

}  // namespace sinew
