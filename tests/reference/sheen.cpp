// SPDX-License-Identifier: MIT
#include "tests/reference/sheen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace sinew::reference {
namespace {

double lambda(double cosine, double alpha) {
  constexpr double fit[2][5] = {{25.3245, 3.32435, 0.16801, -1.27393, -4.85967},
                                {21.5473, 3.82987, 0.19823, -1.97760, -4.32054}};
  const double t = (1.0 - alpha) * (1.0 - alpha);
  double p[5];
  for (int i = 0; i < 5; ++i) p[i] = fit[0][i] * t + fit[1][i] * (1.0 - t);
  const auto l = [&](double x) { return p[0] / (1.0 + p[1] * std::pow(x, p[2])) + p[3] * x + p[4]; };
  return cosine < 0.5 ? std::exp(l(cosine)) : std::exp(2.0 * l(0.5) - l(1.0 - cosine));
}

double greatest(const glm::dvec3& v) { return std::max({v.r, v.g, v.b}); }

double known_albedo(double n_v, double roughness) {
  static std::map<std::pair<double, double>, double> known;  // cached: every light and every pixel asks again
  const auto [at, is_new] = known.try_emplace({n_v, roughness}, 0.0);
  if (is_new) at->second = sheen_albedo(n_v, roughness);
  return at->second;
}

}  // namespace

double sheen_lobe(double n_v, double n_l, double n_h, double roughness) {
  const double alpha = roughness * roughness, sine = std::sqrt(std::max(0.0, 1.0 - n_h * n_h));
  const double distribution = (2.0 + 1.0 / alpha) * std::pow(sine, 1.0 / alpha) / (2.0 * std::numbers::pi);
  return distribution / ((1.0 + lambda(n_v, alpha) + lambda(n_l, alpha)) * 4.0 * n_v * n_l);
}

double sheen_albedo(double n_v, double roughness) {
  constexpr int heights = 60, turns = 24;
  static const auto turned = [] {
    std::array<glm::dvec2, turns> directions;
    for (int j = 0; j < turns; ++j) {
      const double turn = std::numbers::pi * (j + 0.5) / turns;
      directions[j] = {std::cos(turn), std::sin(turn)};
    }
    return directions;
  }();
  const double z = std::max(n_v, 1e-4);
  const glm::dvec3 v(std::sqrt(1.0 - z * z), 0.0, z);
  double sum = 0.0;
  for (int i = 0; i < heights; ++i)
    for (int j = 0; j < turns; ++j) {
      const double u = (i + 0.5) / heights, n_l = u * u;
      const glm::dvec3 l(turned[j] * std::sqrt(1.0 - n_l * n_l), n_l);
      sum += sheen_lobe(z, n_l, glm::normalize(v + l).z, roughness) * n_l * 2.0 * u * 2.0 * std::numbers::pi;
    }
  return sum / (heights * turns);
}

SheenShare sheen_of_light(const SheenLayer& sheen, const glm::dvec3& normal, const glm::dvec3& to_viewer,
                          const glm::dvec3& to_light) {
  const double n_l = glm::dot(normal, to_light), n_v = std::clamp(glm::dot(normal, to_viewer), 1e-4, 1.0);
  if (n_l <= 0.0 || sheen.color == glm::dvec3(0.0)) return {};
  const double n_h = glm::dot(normal, glm::normalize(to_light + to_viewer));
  const double seen = known_albedo(n_v, sheen.roughness), lit = known_albedo(n_l, sheen.roughness);
  return {sheen.color * (sheen_lobe(n_v, n_l, n_h, sheen.roughness) * n_l / std::max(1.0, seen)),
          1.0 - greatest(sheen.color) * std::min(1.0, std::max(seen, lit))};
}

SheenShare sheen_of_ambient(const SheenLayer& sheen, const glm::dvec3& normal, const glm::dvec3& to_viewer) {
  if (sheen.color == glm::dvec3(0.0)) return {};
  const double n_v = std::clamp(glm::dot(normal, to_viewer), 0.0, 1.0);
  const double albedo = std::min(1.0, known_albedo(n_v, sheen.roughness));
  return {sheen.color * albedo, 1.0 - greatest(sheen.color) * albedo};
}

}  // namespace sinew::reference
