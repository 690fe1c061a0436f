// SPDX-License-Identifier: MIT
#include "tests/reference/shade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace sinew::reference {

double coat_share(const Coat& coat, const glm::dvec3& to_viewer) {
  return coat.weight * (0.04 + 0.96 * std::pow(1.0 - std::abs(glm::dot(coat.normal, to_viewer)), 5.0));
}

double ggx(const glm::dvec3& normal, const glm::dvec3& to_viewer, const glm::dvec3& to_light, double roughness) {
  const double n_l = glm::dot(normal, to_light), n_v = std::max(glm::dot(normal, to_viewer), 1e-4);
  if (n_l <= 0.0) return 0.0;
  const double n_h = glm::dot(normal, glm::normalize(to_light + to_viewer)), a2 = std::pow(roughness, 4.0);
  const double distribution = a2 / (std::numbers::pi * std::pow(n_h * n_h * (a2 - 1.0) + 1.0, 2.0));
  return distribution * 0.5 * n_l /
         (n_l * std::sqrt(n_v * n_v * (1.0 - a2) + a2) + n_v * std::sqrt(n_l * n_l * (1.0 - a2) + a2));
}

double stretched_ggx(const ShadedPoint& s, const glm::dvec3& to_light) {
  const glm::dvec3 across = glm::cross(s.normal, s.along), half = glm::normalize(to_light + s.to_viewer);
  const double b = s.roughness * s.roughness, a = b + (1.0 - b) * s.anisotropy * s.anisotropy;
  const auto length_of = [&](const glm::dvec3& v, double n_v) {
    return std::sqrt(std::pow(a * glm::dot(s.along, v), 2.0) + std::pow(b * glm::dot(across, v), 2.0) + n_v * n_v);
  };
  const double n_l = glm::dot(s.normal, to_light), n_v = std::max(glm::dot(s.normal, s.to_viewer), 1e-4);
  if (n_l <= 0.0) return 0.0;
  const double spread = std::pow(glm::dot(s.along, half) / a, 2.0) + std::pow(glm::dot(across, half) / b, 2.0) +
                        std::pow(glm::dot(s.normal, half), 2.0);
  return n_l / (std::numbers::pi * a * b * spread * spread) /
         (2.0 * (n_l * length_of(s.to_viewer, n_v) + n_v * length_of(to_light, n_l)));
}

glm::dvec3 direct(const ShadedPoint& s, const glm::dvec3& to_light, const glm::dvec3& irradiance) {
  const double n_l = glm::dot(s.normal, to_light);
  if (n_l <= 0.0) return glm::dvec3(0.0);
  const double v_h = glm::dot(s.to_viewer, glm::normalize(to_light + s.to_viewer)), edge = std::pow(1.0 - v_h, 5.0);
  const glm::dvec3 diffuse = s.base_color * ((1.0 - s.transmission) * n_l / std::numbers::pi);
  const double specular =
      s.anisotropy > 0.0 ? stretched_ggx(s, to_light) : ggx(s.normal, s.to_viewer, to_light, s.roughness);
  const glm::dvec3 fresnel = s.dielectric_f0 * (1.0 - edge) + glm::dvec3(s.dielectric_f90 * edge);
  const glm::dvec3 dielectric = diffuse * (1.0 - std::max({fresnel.r, fresnel.g, fresnel.b})) + specular * fresnel;
  const glm::dvec3 metal = specular * (s.base_color + (glm::dvec3(1.0) - s.base_color) * edge);
  if (s.film.share == 0.0) return (dielectric * (1.0 - s.metallic) + metal * s.metallic) * irradiance;
  const glm::dvec3 film = film_reflectance(s.film, s.dielectric_f0, v_h);
  const double below = 1.0 - std::min(std::max({film.r, film.g, film.b}), 1.0);
  const glm::dvec3 filmed_dielectric = diffuse * below + specular * film,
                   filmed_metal = specular * film_reflectance(s.film, s.base_color, v_h);
  const double f = s.film.share;
  return ((dielectric * (1.0 - f) + filmed_dielectric * f) * (1.0 - s.metallic) +
          (metal * (1.0 - f) + filmed_metal * f) * s.metallic) *
         irradiance;
}

glm::dvec3 tone_mapped(const glm::dvec3& color) {
  const double x = std::min({color.r, color.g, color.b});
  const glm::dvec3 shifted = color - glm::dvec3(x < 0.08 ? x - 6.25 * x * x : 0.04);
  const double peak = std::max({shifted.r, shifted.g, shifted.b});
  if (peak <= 0.76) return shifted;
  const double compressed = 1.0 - 0.24 * 0.24 / (peak - 0.76 + 0.24);
  const double to_white = 1.0 - 1.0 / (0.15 * (peak - compressed) + 1.0);
  return shifted * (compressed / peak) * (1.0 - to_white) + glm::dvec3(compressed) * to_white;
}

glm::dvec3 tone_mapped_aces(const glm::dvec3& color) {
  constexpr double into[3][3] = {{0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777}};
  constexpr double out[3][3] = {
      {1.60475, -0.53108, -0.07367}, {-0.10208, 1.10813, -0.00605}, {-0.00327, -0.07276, 1.07602}};
  glm::dvec3 film(0.0), shown(0.0);
  for (int row = 0; row < 3; ++row) {
    double v = 0.0;
    for (int k = 0; k < 3; ++k) v += into[row][k] * color[k] / 0.6;
    film[row] = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.432951) + 0.238081);
  }
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k) shown[row] += out[row][k] * film[k];
    shown[row] = std::clamp(shown[row], 0.0, 1.0);
  }
  return shown;
}

double srgb_encoded(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

double srgb_decoded(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace sinew::reference
