// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/light/environment.h"

namespace sinew::viewer {

/// The studio's key light. It casts the shadows; the room itself gives most of the light.
inline constexpr KeyLight kStudioKey{{0.45f, 0.8f, 0.4f}, {0.96f, 0.94f, 0.91f}};

/// Radiance of the studio.
/// Irradiance / pi of surfaces that face the axes, key light included, follows the neutral room of the public
/// glTF-Render-Fidelity pictures: +x 0.5, -x 0.5, +y 1.0, -y 0.25, +z 0.5, -z 1.3. Their bright window is at -z.
/// in   d  unit
glm::vec3 studio_radiance(const glm::vec3& d);

}  // namespace sinew::viewer
