// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/code_residuals.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "runtime/geometry_cache/geometry_format.h"
#include "runtime/geometry_cache/residual_code.h"

namespace sinew {
namespace {

using Zigzags = std::array<std::uint32_t, kBlockPoints>;

Zigzags zigzags_of(const FittedBlock& block, std::size_t axis) {
  Zigzags out;
  for (std::size_t i = 0; i < kBlockPoints; ++i) out[i] = zigzag(block.residuals[axis * kBlockPoints + i]);
  return out;
}

std::size_t bits_of(const Zigzags& numbers, std::uint8_t code, unsigned width) {
  std::size_t bits = kBlockPoints * width;
  for (std::size_t i = 0; i < kBlockPoints; i += 2)
    bits += bits_of_pair(code, numbers[i] >> width, numbers[i + 1] >> width).length;
  return bits;
}

}  // namespace

void choose_codes(FittedBlock& block) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Zigzags numbers = zigzags_of(block, axis);
    std::uint64_t sum = 0;
    std::uint32_t all = 0;
    for (const std::uint32_t z : numbers) {
      sum += z;
      all |= z;
    }
    const auto packed = static_cast<int>(std::bit_width(all));
    const auto middle = static_cast<int>(std::bit_width(sum / kBlockPoints));
    std::size_t fewest = kBlockPoints * static_cast<std::size_t>(packed);
    for (int width = std::max({middle - 3, packed - 8, 0}); width <= std::min<int>(middle, kMaxCodedWidth); ++width)
      for (std::uint8_t code = 1; code <= kResidualCodes; ++code) {
        const std::size_t bits = bits_of(numbers, code, static_cast<unsigned>(width));
        if (bits >= fewest) continue;
        fewest = bits;
        block.motion.code[axis] = code;
        block.motion.width[axis] = static_cast<std::uint8_t>(width);
      }
  }
}

std::vector<std::uint8_t> write_codes(std::span<const FittedBlock> blocks) {
  std::vector<std::uint8_t> out(kCodeHeads);
  bool any = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t first = out.size();
    std::uint64_t waiting = 0;
    unsigned have = 0;
    for (const FittedBlock& block : blocks) {
      const std::uint8_t code = block.motion.code[axis], width = block.motion.width[axis];
      if (code == 0) continue;
      any = true;
      const Zigzags numbers = zigzags_of(block, axis);
      for (std::size_t i = 0; i < kBlockPoints; i += 2) {
        const PairBits pair = bits_of_pair(code, numbers[i] >> width, numbers[i + 1] >> width);
        waiting |= std::uint64_t{pair.bits} << have;
        for (have += pair.length; have >= 8; have -= 8) {
          out.push_back(static_cast<std::uint8_t>(waiting));
          waiting >>= 8;
        }
      }
    }
    if (have > 0) out.push_back(static_cast<std::uint8_t>(waiting));
    const auto size = static_cast<std::uint32_t>(out.size() - first);
    if (axis < 2) std::memcpy(out.data() + axis * sizeof(size), &size, sizeof(size));
  }
  if (!any) out.clear();
  return out;
}

}  // namespace sinew
