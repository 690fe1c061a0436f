// SPDX-License-Identifier: MIT
#include "tests/reference/ambient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "tests/reference/occluded_light.h"

namespace sinew::reference {
namespace {

/// Cosine between the normal and the half vector at quantile `s`: the share s of all half vectors lies closer to the
/// normal.
double half_vector_cosine(double s, double alpha) { return std::sqrt((1.0 - s) / (1.0 + (alpha * alpha - 1.0) * s)); }

/// Sample of the quantile s in [0, 1]. The integrand changes fastest at both ends, so s = u^2 (3 - 2 u) puts more
/// samples there; `weight` = ds.
struct Share {
  double s, weight;
};

Share share_at(int i, int count) {
  const double u = (i + 0.5) / count;
  return {u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u) / count};
}

double fifth_power(double x) { return x * x * (x * x) * x; }

struct Layer {
  glm::dvec3 once, again;
};

Layer layer(const glm::dvec3& f0, double f90, const glm::dvec2& sums) {
  const glm::dvec3 once = f0 * sums.x + glm::dvec3(f90 * sums.y);
  const double rest = 1.0 - sums.x - sums.y;
  const glm::dvec3 mean = f0 + (glm::dvec3(f90) - f0) / 21.0;
  return {once, once * mean * rest / (glm::dvec3(1.0) - mean * rest)};
}

}  // namespace

glm::dvec2 reflected_once(double n_v, double roughness) {
  constexpr int angles = 96, turns = 16;
  static const auto turned = [] {  // kept between calls: a picture calls this once per sample
    std::array<double, turns> cosines;
    for (int j = 0; j < turns; ++j) cosines[j] = std::cos(std::numbers::pi * (j + 0.5) / turns);
    return cosines;
  }();
  const double alpha = roughness * roughness, z = std::max(n_v, 1e-6), x = std::sqrt(1.0 - z * z);
  const double a2 = alpha * alpha;
  glm::dvec2 sum(0.0);
  for (int i = 0; i < angles; ++i) {
    const Share share = share_at(i, angles);
    const double n_h = half_vector_cosine(share.s, alpha), sine = std::sqrt(1.0 - n_h * n_h);
    for (int j = 0; j < turns; ++j) {
      const double v_h = x * sine * turned[j] + z * n_h;
      const double n_l = 2.0 * v_h * n_h - z;
      if (v_h <= 0.0 || n_l <= 0.0) continue;
      const double visibility =
          0.5 / (n_l * std::sqrt(z * z * (1.0 - a2) + a2) + z * std::sqrt(n_l * n_l * (1.0 - a2) + a2));
      const double part = 4.0 * visibility * v_h * n_l / n_h * share.weight / turns, edge = fifth_power(1.0 - v_h);
      sum += part * glm::dvec2(1.0 - edge, edge);
    }
  }
  return sum;
}

double reflected_cosine(double roughness) {
  constexpr int steps = 20000;
  double sum = 0.0, weights = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double n_h = half_vector_cosine((i + 0.5) / steps, roughness * roughness), n_l = 2.0 * n_h * n_h - 1.0;
    if (n_l <= 0.0) continue;
    sum += n_l * n_l;
    weights += n_l;
  }
  return sum / weights;
}

namespace {

/// Light of the gradient around a direction; `left` scales its contrast, 0 = even light from everywhere.
glm::dvec3 from(const AmbientGradient& light, const glm::dvec3& d, double left) {
  const double t = 0.5 + 0.5 * left * glm::dot(d, light.up);
  return light.ground * (1.0 - t) + light.sky * t;
}

glm::dvec3 mirrored(const AmbientGradient& light, const glm::dvec3& n, const glm::dvec3& v, double roughness) {
  return light_around(light, 2.0 * glm::dot(n, v) * n - v, roughness);
}

}  // namespace

glm::dvec3 light_around(const AmbientGradient& light, const glm::dvec3& direction, double roughness) {
  static std::map<double, double> cosines;  // by roughness; most pictures have few different ones
  const auto [known, is_new] = cosines.try_emplace(roughness, 0.0);
  if (is_new) known->second = reflected_cosine(roughness);
  return from(light, direction, known->second);
}

namespace {

/// Reflectance along the normal with the film, which ambient light meets at the angle of the viewer.
glm::dvec3 filmed_f0(const ShadedPoint& s, const glm::dvec3& f0) {
  if (s.film.share == 0.0) return f0;
  const double n_v = std::clamp(glm::dot(s.normal, s.to_viewer), 0.0, 1.0);
  return f0 * (1.0 - s.film.share) + normal_reflectance(film_reflectance(s.film, f0, n_v), n_v) * s.film.share;
}

/// The normal about which a stretched highlight mirrors ambient light.
glm::dvec3 mirror_normal(const ShadedPoint& s) {
  if (s.anisotropy == 0.0) return s.normal;
  const glm::dvec3 across = glm::cross(s.normal, s.along), bent = glm::cross(glm::cross(across, s.to_viewer), across);
  const double left = std::pow(1.0 - s.anisotropy * (1.0 - s.roughness), 4.0);
  return glm::normalize(bent * (1.0 - left) + s.normal * left);
}

}  // namespace

glm::dvec3 ambient(const ShadedPoint& s, const AmbientGradient& light, const Openness& open) {
  const double n_v = std::clamp(glm::dot(s.normal, s.to_viewer), 0.0, 1.0);
  const glm::dvec2 sums = reflected_once(n_v, s.roughness);
  const Layer metal = layer(filmed_f0(s, s.base_color), 1.0, sums),
              coat = layer(filmed_f0(s, s.dielectric_f0), s.dielectric_f90, sums);
  const glm::dvec3 returned = coat.once + coat.again;
  const glm::dvec3 ground =
      s.base_color * (1.0 - std::max({returned.r, returned.g, returned.b})) * (1.0 - s.transmission);
  const glm::dvec3 scattered = (coat.again + ground) * (1.0 - s.metallic) + metal.again * s.metallic;
  const glm::dvec3 reflected = coat.once * (1.0 - s.metallic) + metal.once * s.metallic;
  const glm::dvec3 half_sphere = from(light, s.normal, 2.0 / 3.0);
  const double around = mirrored_visibility(open, s.normal, s.to_viewer, s.roughness);
  return half_sphere * scattered *
             scattered_visibility(open.visibility * open.baked, s.base_color * (1.0 - s.metallic)) +
         reflected * (mirrored(light, mirror_normal(s), s.to_viewer, s.roughness) * around +
                      half_sphere * mirrored_surroundings(open, around, s.base_color));
}

glm::dvec3 passed_through(const ShadedPoint& s) {
  const glm::dvec2 sums = reflected_once(std::clamp(glm::dot(s.normal, s.to_viewer), 0.0, 1.0), s.roughness);
  const Layer surface = layer(filmed_f0(s, s.dielectric_f0), s.dielectric_f90, sums);
  const glm::dvec3 returned = surface.once + surface.again;
  return s.base_color * (1.0 - std::max({returned.r, returned.g, returned.b})) * (1.0 - s.metallic) * s.transmission;
}

glm::dvec3 diffuse_light(const AmbientGradient& light, const glm::dvec3& normal) {
  return from(light, normal, 2.0 / 3.0);
}

glm::dvec3 ambient(const Coat& coat, const glm::dvec3& below, const glm::dvec3& to_viewer, const AmbientGradient& light,
                   const Openness& open) {
  const glm::dvec2 sums = reflected_once(std::clamp(glm::dot(coat.normal, to_viewer), 0.0, 1.0), coat.roughness);
  const double once = sums.x + sums.y;
  const glm::dvec3 half_sphere = from(light, coat.normal, 2.0 / 3.0);
  const double around = mirrored_visibility(open, coat.normal, to_viewer, coat.roughness);
  return (mirrored(light, coat.normal, to_viewer, coat.roughness) * once + half_sphere * (1.0 - once)) * around +
         half_sphere * mirrored_surroundings(open, around, below);
}

}  // namespace sinew::reference
