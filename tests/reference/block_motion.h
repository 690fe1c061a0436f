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

/// Decodes one block.
/// in   payload  of this block;   out  x[192]
inline void move_block(const BlockMotion& motion, std::span<const std::uint8_t> payload,
                       std::span<const std::uint8_t> corners, std::span<const std::int32_t> x1,
                       std::span<const std::int32_t> x2, std::span<std::int32_t> x) {
  const std::vector<std::int32_t> earlier(x2.begin(), x2.end());  // x may be x2
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto row = [&](std::span<const std::int32_t> state, std::size_t i) {
      return std::int64_t{state[axis * kBlockPoints + i]};
    };
    std::vector<std::int64_t> missed;  // per point: the residual that the motion does not predict
    for (std::size_t i = 0; i < kBlockPoints; ++i) {
      const std::uint32_t turned = packed_value(payload, motion.width[axis], i);
      missed.push_back((turned & 1) != 0 ? -std::int64_t{turned / 2} - 1 : turned / 2);
      if (motion.spreads || motion.base == BlockBase::space)
        for (std::size_t k = 0; k < 3; ++k)
          if (corners[3 * i + k] != kNoCorner) missed[i] += (k < 2 ? 1 : -1) * missed[corners[3 * i + k]];
      missed[i] = cut(missed[i]);
      std::int64_t sum = missed[i] + motion.offset[axis];
      if (motion.base != BlockBase::space) {
        const std::int64_t moved = cut(row(x1, i) - row(earlier, i));
        sum += row(x1, i);
        if (motion.base == BlockBase::linear) sum += moved;
        if (motion.base == BlockBase::slower) sum += moved >= 0 ? moved / 2 : -((1 - moved) / 2);
      }
      if (motion.turns) {
        std::uint64_t product = motion.shift > 0 ? std::uint64_t{1} << (motion.shift - 1) : 0;
        for (std::size_t k = 0; k < 3; ++k)
          product += static_cast<std::uint64_t>(std::int64_t{motion.matrix[3 * k + axis]} *
                                                (x1[k * kBlockPoints + i] - std::int64_t{x1[k * kBlockPoints]}));
        const std::int64_t whole = cut(static_cast<std::int64_t>(product)), unit = std::int64_t{1} << motion.shift;
        sum += whole >= 0 ? whole / unit : -((unit - 1 - whole) / unit);
      }
      x[axis * kBlockPoints + i] = cut(sum);
    }
    payload = payload.subspan(std::size_t{8} * motion.width[axis]);
  }
}

}  // namespace sinew::reference
