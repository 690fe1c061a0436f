// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/animation/track.h"

namespace sinew {

/// The keys of one track as integers: component c of a key is low[c] + step[c] * number. The number has width[c] bits,
/// just enough for the range of the track; 0 if the component is constant.
///
/// Rotations may leave out one component, called derived: the one that stays farthest from 0. It follows from the
/// others since keys are unit. Signs of keys are chosen so that it is positive, as q and -q are the same rotation.
struct PackedTrack {
  static constexpr std::uint32_t kMostBits = 24;     ///< per component: float holds such integers exactly
  static constexpr std::uint32_t kMostKeyBits = 56;  ///< bits of one key, at most
  /// Smallest step of a component that has bits. Sampling divides steps by up to 128, and the result must be exact.
  static constexpr float kLeastStep = 0x1p-100f;
  static constexpr std::uint8_t kNoneDerived = 4;

  std::uint32_t components = 0;
  std::uint8_t derived = kNoneDerived;
  std::array<float, 4> low{}, step{};
  std::array<std::uint8_t, 4> width{};
  std::vector<std::uint32_t> numbers;  ///< [key][component] the packed numbers

  std::uint32_t bits_per_key() const noexcept { return std::uint32_t{width[0]} + width[1] + width[2] + width[3]; }
};

/// Packs the keys of a step or linear track so that no key moves by more than `tolerance`. For vectors it is a length,
/// and for weights a difference. For rotations it is the distance by which a point one unit from the axis moves.
/// out  nullopt for cubic and squad tracks, and if a component would need more than kMostBits, or a key more than
///      kMostKeyBits
std::optional<PackedTrack> pack_keys(const Vec3Track& track, double tolerance);
std::optional<PackedTrack> pack_keys(const QuatTrack& track, double tolerance);
std::optional<PackedTrack> pack_keys(const WeightTrack& track, std::uint32_t weight, double tolerance);

/// A key after rounding, with the float arithmetic of sample_clip.
std::array<float, 4> unpack_key(const PackedTrack& track, std::size_t key) noexcept;

/// As above, for a rotation, normalised in double.
glm::quat unpack_rotation(const PackedTrack& track, std::size_t key) noexcept;

}  // namespace sinew
