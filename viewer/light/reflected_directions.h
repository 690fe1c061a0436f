// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "viewer/light/cube_map.h"

namespace sinew::viewer {

/// A direction from which a rough surface with normal +z reflects light towards a viewer at +z.
struct ReflectedDirection {
  glm::vec3 direction;        ///< unit, z above 0
  float source_level = 0.0f;  ///< mip level of the source map whose texels match the sample's solid angle
};

/// Directions reflected at GGX-distributed half vectors; directions below the surface are omitted.
/// eq   h: cos^2 = (1 - s) / (1 + (alpha^2 - 1) s), alpha = roughness^2; l = reflect(-n, h), density D(h) / 4. Level:
///      Krivanek and Colbert, "Real-time Shading with Filtered Importance Sampling" (2008)
/// in   count > 0;   source_size  texels along an edge of the source map
std::vector<ReflectedDirection> reflected_directions(float roughness, std::uint32_t count, std::uint32_t source_size);

}  // namespace sinew::viewer
