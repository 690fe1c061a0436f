// SPDX-License-Identifier: MIT
#include "runtime/graph/space_weights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sinew {
namespace {

void line_weights(std::span<const GraphBlendPoint> points, float x, std::span<float> weights) noexcept {
  std::fill(weights.begin(), weights.end(), 0.0f);
  std::size_t above = 0;
  while (above < points.size() && points[above].x <= x) ++above;
  if (above == 0 || above == points.size()) {
    weights[above == 0 ? 0 : above - 1] = 1.0f;
    return;
  }
  const float u = (x - points[above - 1].x) / (points[above].x - points[above - 1].x);
  weights[above - 1] = 1.0f - u;
  weights[above] = u;
}

}  // namespace

void space_weights(const GraphBlendSpace& space, std::span<const GraphBlendPoint> points, float x, float y,
                   std::span<float> weights) noexcept {
  if (!std::isfinite(x)) x = 0.0f;
  if (!std::isfinite(y)) y = 0.0f;
  line_weights(points, x, weights);
  static_cast<void>(space);
}

}  // namespace sinew
