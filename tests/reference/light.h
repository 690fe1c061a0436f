// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"
#include "runtime/model/scene.h"

namespace sinew::reference {

/// Light at a point: its direction, and the irradiance of a surface that faces it.
struct ArrivingLight {
  glm::dvec3 to_light{0.0, 1.0, 0.0};  ///< unit
  glm::dvec3 irradiance{0.0};
};

/// Light that `light` sends to a point.
/// eq   KHR_lights_punctual: colour * intensity, along -z of the node whatever its scale; for points and spots
///      over distance^2, times clamp(1 - (distance / range)^4), for spots times
///      clamp((cos(angle) - cos(outer)) / max(0.001, cos(inner) - cos(outer)))^2
/// in   point  world space
ArrivingLight arriving(const Light& light, const Affined& world_from_light, const glm::dvec3& point);

}  // namespace sinew::reference
