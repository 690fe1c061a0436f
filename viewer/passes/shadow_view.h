// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "runtime/math/affine.h"
#include "runtime/model/mesh.h"

namespace sinew::viewer {

/// Texels along an edge of a shadow map.
inline constexpr std::uint32_t kShadowSize = 2048;

/// Lights that cast shadows at most: their maps are tiles of one image, which any Vulkan device may have so large.
inline constexpr std::uint32_t kMostShadows = 4;

/// Tiles of the image of so many maps. Map i is at column i % columns, row i / columns.
struct ShadowTiles {
  std::uint32_t columns, rows;

  explicit constexpr ShadowTiles(std::uint32_t maps) noexcept : columns(maps > 1 ? 2 : 1), rows(maps > 2 ? 2 : 1) {}
};

/// A shadow map as its light sees it.
struct ShadowView {
  /// Rows x, y, z, w: x / w and y / w in [-1, 1] over the map, z / w 1 at its near end, 0 at its far end; w = 1 for a
  /// light from far away, else the distance along the light's axis.
  std::array<glm::dvec4, 4> map_from_world{};
  double texel_m = 0.0;  ///< edge of a texel where w is 1

  /// eq   map_from_world * world_from_view
  std::array<glm::dvec4, 4> map_from_view(const Affined& world_from_view) const noexcept;
};

/// Fits the map of a light from far away to everything that casts or receives shadows. It does not depend on the
/// camera, so shadows stand still while it moves.
/// eq   a cube around the sphere around `bounds`, turned so that +z of the map points to the light
/// in   bounds  world space, not empty;   to_light  unit, world space
ShadowView shadow_view(const Aabb& bounds, const glm::dvec3& to_light);

/// The map of a spot light: its cone, between the ends of the sphere around `bounds`.
/// eq   z / w = near (far - d) / (d (far - near)) at the distance d along the axis
/// in   position  world space;   to_light  unit, against the direction of the light;   cone_rad  half angle, at most
///      kWidestCone_rad is covered
ShadowView spot_shadow_view(const Aabb& bounds, const glm::dvec3& position, const glm::dvec3& to_light,
                            double cone_rad);

inline constexpr double kWidestCone_rad = 1.4;

}  // namespace sinew::viewer
