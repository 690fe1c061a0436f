// SPDX-License-Identifier: MIT
#include "viewer/light/studio_sky.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "runtime/math/interpolate.h"

namespace sinew::viewer {
namespace {

/// A rectangular area light that faces the center of the room.
struct Panel {
  glm::vec3 towards;  ///< direction to its center
  glm::vec2 half;     ///< its half width and height at distance 1
  glm::vec3 radiance;
};

constexpr float kSoftEdge = 0.10f;  // half the width of a panel's soft edge, at distance 1

constexpr Panel kPanels[] = {
    {{-0.03f, 0.5f, -1.0f}, {0.80f, 0.40f}, {4.55f, 4.60f, 4.68f}},  // the window
    {{0.45f, 0.2f, 1.0f}, {0.11f, 0.60f}, {1.54f, 1.50f, 1.44f}},    // strips that metals mirror
    {{-1.0f, 0.25f, 0.8f}, {0.20f, 0.80f}, {0.78f, 0.80f, 0.83f}},
    {{0.0f, 0.05f, 1.0f}, {0.45f, 0.45f}, {0.24f, 0.24f, 0.24f}},  // fill from where viewers stand
};

glm::vec3 from_panel(const Panel& panel, const glm::vec3& d) {
  const glm::vec3 back = glm::normalize(panel.towards);
  const float along = glm::dot(d, back);
  if (along <= 0.0f) return glm::vec3(0.0f);
  const glm::vec3 right = glm::normalize(glm::cross(back, {0.0f, 1.0f, 0.0f})), up = glm::cross(right, back);
  const glm::vec2 at = glm::abs(glm::vec2(glm::dot(d, right), glm::dot(d, up)) / along);
  const glm::vec2 inside = glm::smoothstep(panel.half + kSoftEdge, panel.half - kSoftEdge, at);
  return panel.radiance * (inside.x * inside.y);
}

glm::vec3 walls(const glm::vec3& d) {
  constexpr glm::vec3 floor(0.213f, 0.210f, 0.206f), wall(0.169f, 0.170f, 0.172f), ceiling(0.198f, 0.200f, 0.204f);
  return d.y < 0.0f ? lerp(wall, floor, glm::smoothstep(0.0f, 0.5f, -d.y))
                    : lerp(wall, ceiling, glm::smoothstep(0.0f, 1.0f, d.y));
}

}  // namespace

glm::vec3 studio_radiance(const glm::vec3& d) {
  glm::vec3 light = walls(d);
  for (const Panel& panel : kPanels) light += from_panel(panel, d);
  return light;
}

}  // namespace sinew::viewer
