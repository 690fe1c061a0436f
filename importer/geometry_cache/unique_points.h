// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace sinew {

/// Merges vertices that are bit-identical in every frame into points. Texture seams split vertices that always move
/// together.
struct UniquePoints {
  std::vector<std::uint32_t> point_of_vertex;  ///< [vertices] point of each vertex
  std::vector<std::uint32_t> vertex_of_point;  ///< [points] first vertex of each point
};

/// Finds the vertices that share a point.
/// cost O(vertices * frames) expected
UniquePoints find_unique_points(std::span<const std::vector<glm::vec3>> frames);

}  // namespace sinew
