// SPDX-License-Identifier: MIT
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "runtime/math/interpolate.h"
#include "viewer/light/environment.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kStudioSize = 128;  // enough, because the lights have soft edges

/// A rectangular area light that faces the center of the room.
struct Panel {
  glm::vec3 towards;  ///< direction to its center
  glm::vec2 half;     ///< its half width and height at distance 1
  glm::vec3 radiance;
};

constexpr float kSoftEdge = 0.12f;  // width of a panel's soft edge, at distance 1

glm::vec3 from_panel(const Panel& panel, const glm::vec3& d) {
  const glm::vec3 back = glm::normalize(panel.towards);
  const float along = glm::dot(d, back);
  if (along <= 0.0f) return glm::vec3(0.0f);
  const glm::vec3 right = glm::normalize(glm::cross(back, {0.0f, 1.0f, 0.0f})), up = glm::cross(right, back);
  const glm::vec2 at = glm::abs(glm::vec2(glm::dot(d, right), glm::dot(d, up)) / along);
  const glm::vec2 inside = glm::smoothstep(panel.half + kSoftEdge, panel.half - kSoftEdge, at);
  return panel.radiance * (inside.x * inside.y);
}

glm::vec3 room(const glm::vec3& d) {
  constexpr glm::vec3 floor(0.10f, 0.095f, 0.09f), wall(0.17f, 0.17f, 0.18f), ceiling(0.24f, 0.25f, 0.27f);
  return d.y < 0.0f ? lerp(wall, floor, glm::smoothstep(0.0f, 0.5f, -d.y))
                    : lerp(wall, ceiling, glm::smoothstep(0.0f, 1.0f, d.y));
}

glm::vec3 studio(const glm::vec3& d) {
  static constexpr Panel kPanels[] = {
      {{0.55f, 0.75f, 0.6f}, {0.50f, 0.38f}, {1.7f, 1.64f, 1.54f}},
      {{-0.95f, 0.25f, 0.35f}, {0.30f, 0.55f}, {0.62f, 0.68f, 0.78f}},
      {{0.15f, 0.45f, -0.95f}, {0.75f, 0.16f}, {1.5f, 1.54f, 1.66f}},
  };
  glm::vec3 light = room(d);
  for (const Panel& panel : kPanels) light += from_panel(panel, d);
  return light;
}

}  // namespace

CubeMap studio_sky() { return cube_of(kStudioSize, studio); }

std::shared_ptr<const Environment> studio_environment() {
  static const std::shared_ptr<const Environment> made = make_environment(studio_sky());
  return made;
}

}  // namespace sinew::viewer
