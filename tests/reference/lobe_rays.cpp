// SPDX-License-Identifier: MIT
#include "tests/reference/lobe_rays.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace sinew::reference {

std::vector<LobeRay> lobe_rays(const glm::dvec3& n, const glm::dvec3& v, double roughness, int count, double turn) {
  constexpr double golden = 0.6180339887498949;
  const glm::dvec3 x = glm::normalize(glm::cross(std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), n));
  const glm::dvec3 y = glm::cross(n, x);
  const double a2 = std::pow(roughness, 4.0), n_v = glm::dot(n, v);
  std::vector<LobeRay> rays;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double s = (i + 0.5) / count, n_h = std::sqrt((1.0 - s) / (1.0 + (a2 - 1.0) * s));
    const double around = 2.0 * std::numbers::pi * std::fmod(i * golden + turn, 1.0), sine = std::sqrt(1.0 - n_h * n_h);
    const glm::dvec3 h = sine * (std::cos(around) * x + std::sin(around) * y) + n_h * n;
    const double v_h = glm::dot(v, h);
    const glm::dvec3 l = 2.0 * v_h * h - v;
    const double n_l = glm::dot(n, l);
    if (v_h <= 0.0 || n_l <= 0.0) continue;
    const double visibility =
        0.5 / (n_l * std::sqrt(n_v * n_v * (1.0 - a2) + a2) + n_v * std::sqrt(n_l * n_l * (1.0 - a2) + a2));
    rays.push_back({l, visibility * v_h * n_l / n_h});
    sum += rays.back().weight;
  }
  for (LobeRay& ray : rays) ray.weight /= sum;
  return rays;
}

}  // namespace sinew::reference
