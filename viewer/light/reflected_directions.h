// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "viewer/light/cube_map.h"

namespace sinew::viewer {

/// A direction that a rough mirror with normal +z, seen along its normal, reflects light from.
struct ReflectedDirection {
  glm::vec3 direction;        ///< unit, z above 0
  float source_level = 0.0f;  ///< of the pyramid of a cube map: its texels are as large as the sample's share
};

/// Directions distributed as GGX reflects them; those below the surface are left out.
/// eq   h: cos^2 = (1 - s) / (1 + (alpha^2 - 1) s), alpha = roughness^2; l = reflect(-n, h), density D(h) / 4.
///      Level: Krivanek and Colbert, "Real-time Shading with Filtered Importance Sampling" (2008)
/// in   count > 0;   source_size  texels along an edge of the map that is read
std::vector<ReflectedDirection> reflected_directions(float roughness, std::uint32_t count, std::uint32_t source_size);

}  // namespace sinew::viewer
