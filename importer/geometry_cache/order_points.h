// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace sinew {

/// An order of points for a geometry cache.
struct PointOrder {
  std::vector<std::uint32_t> points;  ///< [points] the point at each place: blocks of 64 neighbours that move alike
  std::vector<std::uint8_t> corners;  ///< [3 * 64 * blocks] places in the block of a, b and c, from which a point of a
                                      ///< key frame is predicted as a + b - c (BlockBase::space)
};

/// Splits the points along their widest axis, of some frames, until blocks are left. In a block they are walked over
/// the surface from triangle to triangle, so that each completes a parallelogram where it can, else follows a
/// neighbour.
/// in   frames     [any][points]
///      triangles  [3F] of points; may be empty
PointOrder order_points(std::span<const std::vector<glm::vec3>> frames, std::span<const std::uint32_t> triangles);

}  // namespace sinew
