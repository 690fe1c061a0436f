// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"
#include "runtime/model/mesh.h"

namespace sinew::viewer {

/// Texels along an edge of the shadow map.
inline constexpr std::uint32_t kShadowSize = 2048;

/// The shadow map as a light sees it that shines from far away.
struct ShadowView {
  Affined map_from_world;  ///< x and y in [-1, 1] over the map; z 1 at its near end, 0 at its far end
  double texel_m = 0.0;    ///< edge of a texel
};

/// Fits the map to everything that casts or receives shadows. It does not depend on the camera, so shadows stand still
/// while it moves.
/// eq   a cube around the sphere around `bounds`, turned so that +z of the map points to the light
/// in   bounds  world space, not empty;   to_light  unit, world space
ShadowView shadow_view(const Aabb& bounds, const glm::dvec3& to_light);

}  // namespace sinew::viewer
