// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace sinew::viewer {

inline constexpr std::uint32_t kCubeFaces = 6;

/// Radiance from every direction, stored on the faces of a cube.
/// eq   Vulkan 1.3, "Cube Map Face Selection": faces +x, -x, +y, -y, +z, -z, seen from inside, rows from the top
struct CubeMap {
  std::uint32_t size = 0;         ///< texels along an edge
  std::vector<glm::vec3> texels;  ///< [6 * size * size] linear radiance
};

/// The direction through a point of a face; not normalised.
/// in   face < 6;   u, v in [-1, 1], pointing right and down
glm::vec3 face_direction(std::uint32_t face, float u, float v) noexcept;

/// The unit direction through the centre of a texel of a face of `size` texels.
glm::vec3 texel_direction(std::uint32_t face, std::uint32_t x, std::uint32_t y, std::uint32_t size) noexcept;

/// Solid angle of a texel, in steradians. The sum over a cube with 8 texels along an edge is 4 pi within 1 %, and
/// closer for larger cubes.
/// eq   dA / |p|^3 at the centre
float texel_solid_angle(std::uint32_t x, std::uint32_t y, std::uint32_t size) noexcept;

/// A cube map that samples `radiance(direction)` at each texel center.
template <class Radiance>
CubeMap cube_of(std::uint32_t size, const Radiance& radiance) {
  CubeMap cube{size, {}};
  cube.texels.reserve(std::size_t{kCubeFaces} * size * size);
  for (std::uint32_t face = 0; face < kCubeFaces; ++face)
    for (std::uint32_t y = 0; y < size; ++y)
      for (std::uint32_t x = 0; x < size; ++x) cube.texels.push_back(radiance(texel_direction(face, x, y, size)));
  return cube;
}

/// A cube map of half the size; each texel is the mean of four.
/// in   cube.size even
CubeMap halved(const CubeMap& cube);

/// Bilinearly filtered radiance from a direction. Filtering does not cross face edges: texels are clamped there.
/// in   direction  any length except 0
glm::vec3 sample(const CubeMap& cube, const glm::vec3& direction) noexcept;

}  // namespace sinew::viewer
