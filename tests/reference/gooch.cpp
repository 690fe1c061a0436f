// SPDX-License-Identifier: MIT
#include "tests/reference/gooch.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sinew::reference {
namespace {

double smooth(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double far_if_empty(double distance) { return distance > 0.0 ? distance : std::numeric_limits<double>::infinity(); }

}  // namespace

glm::dvec3 gooch_tone(const glm::dvec3& base, const glm::dvec3& n, const glm::dvec3& to_light,
                      const glm::dvec3& to_viewer) {
  const glm::dvec3 cool = glm::dvec3(0.0, 0.0, 0.4) + 0.2 * base, warm = glm::dvec3(0.4, 0.4, 0.0) + 0.6 * base;
  const double t = 0.5 * (1.0 + glm::dot(n, to_light));
  const glm::dvec3 mirrored = 2.0 * glm::dot(n, to_light) * n - to_light;
  const double white = std::clamp(100.0 * glm::dot(mirrored, to_viewer) - 97.0, 0.0, 1.0);
  const glm::dvec3 shade = glm::clamp((1.0 - t) * cool + t * warm, 0.0, 1.0);
  return shade * (1.0 - white) + glm::dvec3(white);
}

double outline(const std::array<OutlinePixel, 3>& row, double pixels_per_metre, bool parallel) {
  const double d = row[1].distance_m, a = far_if_empty(row[0].distance_m), b = far_if_empty(row[2].distance_m);
  const double behind_m = parallel ? a + b - 2.0 * d : d * (2.0 - d / a - d / b);
  double line = smooth(4.0, 8.0, behind_m * pixels_per_metre);
  for (const OutlinePixel& outer : {row[0], row[2]})
    if (outer.normal != glm::dvec3(0.0))
      line = std::max(line, 1.0 - smooth(0.7, 0.87, glm::dot(row[1].normal, outer.normal)));
  return line;
}

}  // namespace sinew::reference
