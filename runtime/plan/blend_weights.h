// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/jobs/blend_poses.h"

namespace sinew {

/// Weighted mean of the morph weights of several layers; where the layers' weights sum to less than 1 the rest weights
/// fill up, as for poses.
/// eq   out[i] = (sum(layer.weight * x_layer[i]) + r * rest[i]) / (sum(layer.weight) + r),  r = max(0, 1 - sum(layer.weight));
///      magnitudes below 1e-20 become 0 (N26)
/// in   layers[L]  only their weights are read;   rest[W];   layer_weights(l)[W] begins at first for l = 0, at others[(l - 1) * W] for later ones
/// out  first      the blended weights
/// cost O(W * L), no allocation
void blend_weights(std::span<const BlendLayer> layers, std::span<const float> rest, std::span<float> first,
                   std::span<const float> others) noexcept;

}  // namespace sinew
