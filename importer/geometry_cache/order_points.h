// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace sinew {

/// An order of points for a geometry cache.
struct PointOrder {
  std::vector<std::uint32_t> points;  ///< [points] point at each position; blocks of 64 neighbours with similar motion
  /// [3 * 64 * blocks] positions of a, b and c in the block; a key frame predicts a point as a + b - c
  /// (BlockBase::space).
  std::vector<std::uint8_t> corners;
};

/// Splits the points recursively along their widest axis (over some frames) into blocks. Within a block, walks over the
/// surface from triangle to triangle, so that most points complete a parallelogram; others follow a neighbour.
/// in   frames     [any count][points]
///      triangles  [3F] point indices; may be empty
PointOrder order_points(std::span<const std::vector<glm::vec3>> frames, std::span<const std::uint32_t> triangles);

}  // namespace sinew
