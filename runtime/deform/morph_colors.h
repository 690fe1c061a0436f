// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/model/morph_set.h"

namespace sinew {

/// Adds the COLOR_0 displacements of all targets whose weight is not zero.
/// eq   c' = clamp(c + sum(weight[i] * delta[i]), 0, 1)   (glTF 2.0, "Morph Targets"; G47)
/// in   colors[V], weights[T], any sign and size
/// out  out[V]     must not overlap `colors`
/// cost O(V + active deltas), no allocation
void morph_colors(const MorphSet& morphs, std::span<const float> weights, std::span<const glm::vec4> colors,
                  std::span<glm::vec4> out) noexcept;

}  // namespace sinew
