// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/light/environment.h"

namespace sinew::viewer {

/// The low sun of the sunset. Its disk is not part of the sky, because it lights as a key light.
inline constexpr KeyLight kSun{{0.62f, 0.34f, 0.70f}, {2.5f, 1.62f, 0.92f}};

/// Radiance of a sky after which the sun sets: warm around the sun, blue above, brown ground.
/// in   d  unit
glm::vec3 sunset_radiance(const glm::vec3& d);

/// Radiance of an overcast sky.
/// eq   CIE S 011 (Moon and Spencer 1942): radiance from an elevation is proportional to (1 + 2 sin(elevation)) / 3
/// in   d  unit
glm::vec3 overcast_radiance(const glm::vec3& d);

}  // namespace sinew::viewer
