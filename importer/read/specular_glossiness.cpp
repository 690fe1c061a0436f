// SPDX-License-Identifier: MIT
#include "importer/read/specular_glossiness.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

constexpr double kDielectric = 0.04;
constexpr double kTiny = 1e-6;

/// Perceived brightness of a linear colour   (HSP colour model, Finley 2006).
double perceived(const glm::dvec3& c) noexcept {
  return std::sqrt(0.299 * c.r * c.r + 0.587 * c.g * c.g + 0.114 * c.b * c.b);
}

double solve_metallic(double diffuse, double specular, double one_minus_strength) noexcept {
  if (specular < kDielectric) return 0.0;
  const double a = kDielectric;
  const double b = diffuse * one_minus_strength / (1.0 - kDielectric) + specular - 2.0 * kDielectric;
  const double c = kDielectric - specular;
  const double root = std::sqrt(std::max(b * b - 4.0 * a * c, 0.0));
  return std::clamp((-b + root) / (2.0 * a), 0.0, 1.0);
}

}  // namespace

MetallicRoughness to_metallic_roughness(const SpecularGlossiness& s) noexcept {
  const double one_minus_strength = 1.0 - std::max({s.specular.r, s.specular.g, s.specular.b});
  MetallicRoughness out;
  out.metallic = solve_metallic(perceived(s.diffuse), perceived(s.specular), one_minus_strength);
  out.roughness = 1.0 - s.glossiness;
  const double m = out.metallic;
  const glm::dvec3 from_diffuse = s.diffuse * (one_minus_strength / (1.0 - kDielectric) / std::max(1.0 - m, kTiny));
  const glm::dvec3 from_specular = (s.specular - glm::dvec3(kDielectric * (1.0 - m))) / std::max(m, kTiny);
  out.base_color = glm::clamp(from_diffuse + (from_specular - from_diffuse) * (m * m), 0.0, 1.0);
  return out;
}

}  // namespace sinew
