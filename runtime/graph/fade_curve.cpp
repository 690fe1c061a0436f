// SPDX-License-Identifier: MIT
#include "runtime/graph/fade_curve.h"

#include <cstddef>

namespace sinew {

std::vector<GraphFadeKey> fade_curve_keys(float start_slope, float end_slope, std::span<const GraphFadeKey> points) {
  std::vector<GraphFadeKey> keys{{0.0f, 0.0f, start_slope}};
  keys.insert(keys.end(), points.begin(), points.end());
  keys.push_back({1.0f, 1.0f, end_slope});
  const auto distance = [&](std::size_t i) {
    return static_cast<double>(keys[i + 1].at) - static_cast<double>(keys[i].at);
  };
  const auto secant = [&](std::size_t i) {
    return (static_cast<double>(keys[i + 1].share) - static_cast<double>(keys[i].share)) / distance(i);
  };
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const double before = secant(i - 1), after = secant(i), h0 = distance(i - 1), h1 = distance(i);
    const double slope =
        before * after > 0.0 ? 3.0 * (h0 + h1) / ((2.0 * h1 + h0) / before + (h1 + 2.0 * h0) / after) : 0.0;
    keys[i].slope = static_cast<float>(slope);
  }
  return keys;
}

}  // namespace sinew
