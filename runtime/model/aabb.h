// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/vectors.h"

namespace sinew {

/// Axis-aligned box; empty while lower > upper.
struct Aabb {
  glm::vec3 lower{1e30f};
  glm::vec3 upper{-1e30f};

  bool empty() const noexcept { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
  void add(const glm::vec3& p) noexcept {
    const auto smaller = [](float a, float b) { return b < a ? b : a; };
    const auto larger = [](float a, float b) { return a < b ? b : a; };
    lower = {smaller(lower.x, p.x), smaller(lower.y, p.y), smaller(lower.z, p.z)};
    upper = {larger(upper.x, p.x), larger(upper.y, p.y), larger(upper.z, p.z)};
  }
};

}  // namespace sinew
