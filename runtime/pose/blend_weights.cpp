// SPDX-License-Identifier: MIT
#include "runtime/pose/blend_weights.h"

#include <algorithm>

#include "runtime/math/negligible.h"

namespace sinew {

void blend_weights(std::span<const BlendLayer> layers, std::span<const float> rest, std::span<float> first,
                   std::span<const float> others) noexcept {
  double total = 0.0;
  for (const BlendLayer& layer : layers) total += static_cast<double>(layer.weight);
  const double rest_share = std::max(0.0, 1.0 - total);
  const std::size_t count = first.size();
  for (std::size_t i = 0; i < count; ++i) {
    double sum = static_cast<double>(layers[0].weight) * static_cast<double>(first[i]);
    for (std::size_t l = 1; l < layers.size(); ++l)
      sum += static_cast<double>(layers[l].weight) * static_cast<double>(others[(l - 1) * count + i]);
    const double mean = (sum + rest_share * static_cast<double>(rest[i])) / (total + rest_share);
    first[i] = flushed(static_cast<float>(mean));
  }
}

}  // namespace sinew
