// SPDX-License-Identifier: MIT
#include <cmath>

#include "viewer/light/environment.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kGradientSize = 128;  // so that the roughest level still has four texels along an edge

}  // namespace

double mean_reflected_cosine(double roughness) {
  constexpr int steps = 2048;
  const double alpha2 = std::pow(roughness, 4.0);
  double sum = 0.0, weights = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) / steps, z = 2.0 * (1.0 - s) / (1.0 + (alpha2 - 1.0) * s) - 1.0;
    if (z <= 0.0) break;
    sum += z * z;
    weights += z;
  }
  return sum / weights;
}

std::shared_ptr<const Environment> gradient_environment(const Gradient& gradient) {
  const glm::vec3 middle = 0.5f * (gradient.sky + gradient.ground), slope = 0.5f * (gradient.sky - gradient.ground);
  auto made = std::make_shared<Environment>();
  made->diffuse[0] = middle;
  made->diffuse[1] = slope * (2.0f / 3.0f);
  for (std::uint32_t level = 0; level < kEnvironmentLevels; ++level) {
    const double roughness = static_cast<double>(level) / (kEnvironmentLevels - 1);
    const auto left = static_cast<float>(mean_reflected_cosine(roughness));
    made->reflected.push_back(
        cube_of(kGradientSize >> level, [&](const glm::vec3& d) { return middle + slope * (left * d.y); }));
  }
  return made;
}

std::shared_ptr<const Environment> plain_environment() {
  static const std::shared_ptr<const Environment> made = gradient_environment({});
  return made;
}

}  // namespace sinew::viewer
