// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <span>

#include "runtime/base/same_bits.h"
#include "runtime/plan/frame_input.h"

namespace sinew {

/// Whether layers give the same pose, bit for bit: numbers by their bits, where there may be two zeros.
inline bool same_layers(std::span<const ClipLayer> a, std::span<const ClipLayer> b) noexcept {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ClipLayer& x, const ClipLayer& y) {
    return x.clip == y.clip && same_bits(x.time_s, y.time_s) && same_bits(x.weight, y.weight) && x.mask == y.mask &&
           x.kind == y.kind;
  });
}

}  // namespace sinew
