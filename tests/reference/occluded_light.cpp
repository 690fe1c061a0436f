// SPDX-License-Identifier: MIT
#include "tests/reference/occluded_light.h"

#include <algorithm>

namespace sinew::reference {

glm::dvec3 scattered_visibility(double visibility, const glm::dvec3& albedo) {
  glm::dvec3 out(0.0);
  for (int i = 0; i < 3; ++i) {
    const double a = 2.0404 * albedo[i] - 0.3324, b = 0.6417 - 4.7951 * albedo[i], c = 2.7552 * albedo[i] + 0.6903;
    out[i] = std::min(1.0, std::max(visibility, ((a * visibility + b) * visibility + c) * visibility));
  }
  return out;
}

}  // namespace sinew::reference
