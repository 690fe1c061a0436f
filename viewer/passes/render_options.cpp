// SPDX-License-Identifier: MIT
#include "viewer/passes/render_options.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace sinew::viewer {

namespace {

float half_diagonal(const Aabb& bounds) {
  const float half = bounds.empty() ? 0.0f : 0.5f * glm::length(bounds.upper - bounds.lower);
  return half > 0.0f ? half : 1.0f;
}

}  // namespace

void Lighting::use(std::shared_ptr<const Environment> chosen) {
  environment = std::move(chosen);
  if (!environment || !environment->key) return;
  to_key = environment->key->to_light;
  key = environment->key->irradiance;
}

AmbientOcclusion ambient_occlusion_for(const Aabb& bounds) {
  AmbientOcclusion ao;
  ao.radius_m = 0.1f * half_diagonal(bounds);
  ao.surface_epsilon_m = 0.02f * ao.radius_m;
  ao.fade_start_m = 0.4f * ao.radius_m;
  ao.fade_end_m = 2.0f * ao.radius_m;
  return ao;
}

Ground ground_for(const Aabb& bounds) {
  constexpr float kBelow = 0.002f;  // relative to half the diagonal
  const float half = half_diagonal(bounds);
  Ground ground;
  ground.bounds = bounds;
  if (!bounds.empty()) {
    ground.middle = 0.5 * (glm::dvec3(bounds.lower) + glm::dvec3(bounds.upper));
    ground.middle.y = static_cast<double>(bounds.lower.y) - static_cast<double>(kBelow * half);
  }
  ground.radius_m = 3.0f * half;
  ground.grid_step_m = std::pow(10.0f, std::floor(std::log10(ground.radius_m / 3.0f)));
  return ground;
}

RenderOptions render_options_for(const Aabb& bounds, const glm::dvec3& eye) {
  RenderOptions options;
  options.ao = ambient_occlusion_for(bounds);
  options.ground = ground_for(bounds);
  const glm::vec3 centre = bounds.empty() ? glm::vec3(0.0f) : 0.5f * (bounds.lower + bounds.upper);
  const float distance = static_cast<float>(glm::length(eye - glm::dvec3(centre)));
  const float radius = half_diagonal(bounds);
  options.depth_range = {std::max(distance - radius, 0.0f), distance + radius};
  return options;
}

}  // namespace sinew::viewer
