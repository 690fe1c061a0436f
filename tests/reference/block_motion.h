// SPDX-License-Identifier: MIT
// The equation of BlockMotion, point by point. It uses 64-bit integers and cuts the result to 32 bits.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/geometry_cache/block_motion.h"

namespace sinew::reference {

inline std::int32_t cut(std::int64_t number) { return static_cast<std::int32_t>(static_cast<std::uint64_t>(number)); }

/// Value `index` of an array of integers of `width` bits each, lowest bits first.
inline std::uint32_t packed_value(std::span<const std::uint8_t> bytes, unsigned width, std::size_t index) {
  std::uint32_t value = 0;
  for (unsigned bit = 0; bit < width; ++bit) {
    const std::size_t at = index * width + bit;
    value |= static_cast<std::uint32_t>(bytes[at / 8] >> (at % 8) & 1) << bit;
  }
  return value;
}

/// Coordinate `axis` of point i as the motion alone moves it.
inline std::int64_t moved_alone(const BlockMotion& motion, std::span<const std::int32_t> x1,
                                std::span<const std::int32_t> x2, std::size_t axis, std::size_t i) {
  std::int64_t sum = motion.offset[axis];
  if (motion.base == BlockBase::space) return sum;
  const std::size_t at = axis * kBlockPoints + i;
  const std::int64_t moved = cut(std::int64_t{x1[at]} - x2[at]);
  sum += x1[at];
  if (motion.base == BlockBase::linear) sum += moved;
  if (motion.base == BlockBase::slower) sum += moved >= 0 ? moved / 2 : -((1 - moved) / 2);
  if (!motion.turns) return cut(sum);
  std::uint64_t product = motion.shift > 0 ? std::uint64_t{1} << (motion.shift - 1) : 0;
  for (std::size_t k = 0; k < 3; ++k)
    product += static_cast<std::uint64_t>(std::int64_t{motion.matrix[3 * k + axis]} *
                                          (x1[k * kBlockPoints + i] - std::int64_t{x1[k * kBlockPoints]}));
  const std::int64_t whole = cut(static_cast<std::int64_t>(product)), unit = std::int64_t{1} << motion.shift;
  return cut(sum + (whole >= 0 ? whole / unit : -((unit - 1 - whole) / unit)));
}

/// The part of point i's miss that the misses of earlier points predict, along one axis.
inline std::int64_t spread_to(const BlockMotion& motion, std::span<const std::uint8_t> corners,
                              std::span<const std::int64_t> missed, std::size_t i) {
  if (!motion.spreads && motion.base != BlockBase::space) return 0;
  const auto of = [&](std::size_t k) { return corners[3 * i + k] == kNoCorner ? 0 : missed[corners[3 * i + k]]; };
  if (!motion.means) return of(0) + of(1) - of(2);
  const std::int64_t both = cut(of(0) + (corners[3 * i + 1] == kNoCorner ? of(0) : of(1)));
  return both >= 0 ? both / 2 : -((1 - both) / 2);
}

/// Decodes one block.
/// in   payload  of this block;   uppers  [192] or empty;   out  x[192]
inline void move_block(const BlockMotion& motion, std::span<const std::uint8_t> payload,
                       std::span<const std::uint8_t> corners, std::span<const std::int32_t> x1,
                       std::span<const std::int32_t> x2, std::span<std::int32_t> x, bool centred = false,
                       std::span<const std::uint8_t> uppers = {}) {
  const std::vector<std::int32_t> earlier(x2.begin(), x2.end());  // x may be x2
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<std::int64_t> missed;  // per point: what the motion does not predict
    for (std::size_t i = 0; i < kBlockPoints; ++i) {
      const std::size_t at = axis * kBlockPoints + i;
      std::uint64_t turned = packed_value(payload, motion.width[axis], i);
      if (motion.code[axis] > 0) turned += std::uint64_t{uppers[at]} << motion.width[axis];
      const std::uint32_t code = static_cast<std::uint32_t>(turned);
      const std::int64_t residual = (code & 1) != 0 ? -std::int64_t{code / 2} - 1 : code / 2;
      const std::int64_t moved = moved_alone(motion, x1, earlier, axis, i);
      const std::int64_t predicted = cut(moved + spread_to(motion, corners, missed, i));
      std::int64_t now = predicted + residual;
      if (centred && axis > 0) now = predicted + ((predicted - x[i]) % 2 != 0 ? 1 : 0) + 2 * residual;
      x[at] = cut(now);
      missed.push_back(cut(now - moved));
    }
    payload = payload.subspan(std::size_t{8} * motion.width[axis]);
  }
}

}  // namespace sinew::reference
