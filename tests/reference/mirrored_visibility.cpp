// SPDX-License-Identifier: MIT
#include "tests/reference/mirrored_visibility.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace sinew::reference {

double overlap(double cos_a, double cos_b, double cos_between) {
  const double a = std::acos(cos_a), b = std::acos(cos_b), between = std::acos(std::clamp(cos_between, -1.0, 1.0));
  // Up to `nearest` the smaller circle lies in the larger one; from `farthest` on the circles share nothing.
  const double nearest = std::abs(a - b), farthest = a + b;
  if (between >= farthest) return 0.0;
  const double area = 1.0 - std::max(cos_a, cos_b);
  if (between <= nearest) return area;
  const double part = (farthest - between) / (farthest - nearest);
  return area * part * part * (3.0 - 2.0 * part);
}

double mirrored_visibility(const Openness& open, const glm::dvec3& normal, const glm::dvec3& to_viewer,
                           double roughness) {
  if (!open.bend) return open.visibility * open.baked;
  const glm::dvec3 bent = glm::normalize(normal + *open.bend);
  const glm::dvec3 mirror = 2.0 * glm::dot(normal, to_viewer) * normal - to_viewer;
  const double lobe = std::pow(10.0, -roughness * roughness - 0.1);
  const double hidden = std::clamp(1.0 - open.visibility / std::max(glm::dot(bent, normal), 0.01), 0.0, 1.0);
  const double seen = overlap(std::sqrt(hidden), lobe, glm::dot(mirror, bent)),
               most = overlap(0.0, lobe, glm::dot(mirror, normal));
  const double cone = std::min(seen / most, 1.0), rough = roughness * roughness;
  return open.baked * (cone * (1.0 - rough) + open.visibility * rough);
}

glm::dvec3 mirrored_surroundings(const Openness& open, double mirrored, const glm::dvec3& color) {
  return open.bend ? open.visibility * (open.baked - mirrored) * color : glm::dvec3(0.0);
}

}  // namespace sinew::reference
