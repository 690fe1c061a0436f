// SPDX-License-Identifier: MIT
#include "tests/reference/light.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace sinew::reference {
namespace {

/// Attenuation at this distance by the light's range; range 0 = unlimited.
double range_share(double range_m, double distance_m) {
  if (range_m == 0.0) return 1.0;
  return std::clamp(1.0 - std::pow(distance_m / range_m, 4.0), 0.0, 1.0);
}

/// Attenuation of a spot light at this angle from its axis.
double cone_share(const Light& light, double angle_rad) {
  const double inner = std::cos(static_cast<double>(light.inner_cone_rad)),
               outer = std::cos(static_cast<double>(light.outer_cone_rad));
  const double edge = std::clamp((std::cos(angle_rad) - outer) / std::max(0.001, inner - outer), 0.0, 1.0);
  return edge * edge;
}

}  // namespace

ArrivingLight arriving(const Light& light, const Affined& world_from_light, const glm::dvec3& point) {
  const glm::dvec3 emitted = glm::dvec3(light.color) * static_cast<double>(light.intensity);
  const glm::dvec3 axis = glm::normalize(transform_vector(world_from_light, glm::dvec3(0.0, 0.0, -1.0)));
  if (light.kind == Light::Kind::directional) return {-axis, emitted};
  const glm::dvec3 ray = point - translation_of(world_from_light);
  const double distance = glm::length(ray);
  glm::dvec3 irradiance = emitted / (distance * distance) * range_share(static_cast<double>(light.range_m), distance);
  if (light.kind == Light::Kind::spot)
    irradiance *= cone_share(light, std::acos(std::clamp(glm::dot(axis, ray / distance), -1.0, 1.0)));
  return {-ray / distance, irradiance};
}

}  // namespace sinew::reference
