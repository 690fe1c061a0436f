// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/pose/blend_poses.h"

namespace sinew {

/// Weighted mean of the morph weights of several layers. Where the layer weights sum to less than 1, the rest weights
/// get the remaining weight, as in BlendPosesJob.
/// eq   out[i] = (sum(w[l] * x[l][i]) + r * rest[i]) / (sum(w[l]) + r),  r = max(0, 1 - sum(w[l]));
///      magnitudes below 1e-20 become 0, because denormal numbers are slow
/// in   layers[L]  only their weights w[l] are read;   rest[W] first[W], others[(L - 1) * W]  the morph weights x[0],
///      then x[1], x[2], ...
/// out  first[W]   the blended weights
/// cost O(W * L), no allocation
void blend_weights(std::span<const BlendLayer> layers, std::span<const float> rest, std::span<float> first,
                   std::span<const float> others) noexcept;

}  // namespace sinew
