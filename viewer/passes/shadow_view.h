// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "runtime/math/affine.h"
#include "runtime/model/mesh.h"

namespace sinew::viewer {

/// Texels along an edge of a shadow map.
inline constexpr std::uint32_t kShadowSize = 2048;

/// Largest number of lights that cast shadows. Their maps are tiles of one 4096 x 4096 image, a size that every Vulkan
/// device supports.
inline constexpr std::uint32_t kMostShadows = 4;

/// Tile layout of an image of `maps` shadow maps. Map i is at column i % columns, row i / columns.
struct ShadowTiles {
  std::uint32_t columns, rows;

  explicit constexpr ShadowTiles(std::uint32_t maps) noexcept : columns(maps > 1 ? 2 : 1), rows(maps > 2 ? 2 : 1) {}
};

/// Projection of a shadow map.
struct ShadowView {
  /// Matrix rows x, y, z, w. x / w and y / w are in [-1, 1] over the map; z / w is 1 at the near end and 0 at the far
  /// end. w is 1 for a directional light, else the distance along the light's axis.
  std::array<glm::dvec4, 4> map_from_world{};
  double texel_m = 0.0;  ///< size of a texel where w is 1

  /// Matrix rows from another space to the map.
  /// eq   map_from_world * world_from_space
  std::array<glm::dvec4, 4> map_from(const Affined& world_from_space) const noexcept;
};

/// Fits the map of a directional light to the bounds of all casters and receivers. Independent of the camera, so
/// shadows do not shimmer while it moves.
/// eq   the cube around the bounding sphere of `bounds`, rotated so that +z of the map points to the light
/// in   bounds  world space, not empty;   to_light  unit, world space
ShadowView shadow_view(const Aabb& bounds, const glm::dvec3& to_light);

/// The map of a spot light: its cone, limited to the depth range of the bounding sphere of `bounds`.
/// eq   z / w = near (far - d) / (d (far - near)) at the distance d along the axis
/// in   position  world space;   to_light  unit vector towards the light;   cone_rad  half angle, clamped to
///      kWidestCone_rad
ShadowView spot_shadow_view(const Aabb& bounds, const glm::dvec3& position, const glm::dvec3& to_light,
                            double cone_rad);

inline constexpr double kWidestCone_rad = 1.4;

}  // namespace sinew::viewer
