// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/graph/graph_nodes.h"

namespace sinew {

inline constexpr std::size_t kMostSpacePoints = 32;

/// Weights of a blend space's points at a place. Internal to graph/.
/// in   points[P]  1 to kMostSpacePoints;   values that are not finite count as 0
/// out  weights[P]  >= 0, they sum to 1
void space_weights(const GraphBlendSpace& space, std::span<const GraphBlendPoint> points, float x, float y,
                   std::span<float> weights) noexcept;

}  // namespace sinew
