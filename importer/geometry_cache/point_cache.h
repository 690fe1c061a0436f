// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "importer/import_error.h"

namespace sinew {

/// Positions of points over time, without the mesh that they belong to.
struct PointCache {
  std::vector<std::vector<glm::vec3>> frames;  ///< [frames][points]
  double start_s = 0.0, frame_s = 1.0 / 30.0;

  std::size_t point_count() const noexcept { return frames.empty() ? 0 : frames[0].size(); }
};

/// Reads a NewTek MDD file (big-endian, with times in seconds) or a 3ds Max PC2 file (little-endian, told by its first
/// bytes, with times counted in frames).
/// in   name  stands for the file in errors
///      fps   frames per second: of PC2 files, and of files with one frame
/// err  points-size    the file is shorter or longer than its counts say, or holds no frame
///      points-header  a PC2 file of another version, or with a step that is no step
///      points-times   times that are not finite, or not evenly spaced
///      points-values  a position that is not finite
/// cost O(bytes); memory below twice the file
ImportResult<PointCache> read_point_cache(std::span<const std::byte> bytes, const std::string& name, double fps);

/// Which axis of a point cache points up. Exporters write a mesh with y up and its points with z up.
enum class UpAxis : std::uint8_t { y, z };

/// Turns points with z up to y up: (x, y, z) becomes (x, z, -y).
void turn_to_y_up(PointCache& points);

/// Finds which axis is up by comparing the first frame with the mesh at rest.
/// in   rest  [points], y up
/// err  points-count  the points are not as many as the vertices
///      points-axes   the first frame is the mesh at rest in neither or in both ways: who bakes must say
ImportResult<UpAxis> find_up_axis(const PointCache& points, std::span<const glm::vec3> rest, const std::string& name);

}  // namespace sinew
