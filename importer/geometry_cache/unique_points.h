// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace sinew {

/// Vertices with the same bits in every frame are one point: seams of texture coordinates split vertices that never
/// part.
struct UniquePoints {
  std::vector<std::uint32_t> point_of_vertex;  ///< [vertices]
  std::vector<std::uint32_t> vertex_of_point;  ///< [points] the first such vertex
};

/// cost O(vertices * frames) expected
UniquePoints find_unique_points(std::span<const std::vector<glm::vec3>> frames);

}  // namespace sinew
