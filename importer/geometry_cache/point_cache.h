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

/// Point positions over time, without the mesh.
struct PointCache {
  std::vector<std::vector<glm::vec3>> frames;  ///< [frames][points] positions in metres
  double start_s = 0.0, frame_s = 1.0 / 30.0;

  std::size_t point_count() const noexcept { return frames.empty() ? 0 : frames[0].size(); }
};

/// Reads a NewTek MDD file (big-endian, times in seconds) or a 3ds Max PC2 file (little-endian, times in frames). PC2
/// is detected from its first bytes.
/// in   name  name of the file in errors
///      fps   frames per second: of PC2 files, and of files with one frame
/// err  points-size    the size does not match the counts, or there is no frame
///      points-header  a PC2 file of another version, or with an invalid frame step
///      points-times   times that are not finite or not evenly spaced
///      points-values  a position that is not finite
/// cost O(bytes); memory below twice the file
ImportResult<PointCache> read_point_cache(std::span<const std::byte> bytes, const std::string& name, double fps);

/// The up axis of a point cache. Exporters often write the mesh with y up and the points with z up.
enum class UpAxis : std::uint8_t { y, z };

/// Converts points from z up to y up: (x, y, z) becomes (x, z, -y).
void turn_to_y_up(PointCache& points);

/// Detects the up axis by comparing the first frame with the rest mesh.
/// in   rest  [points], y up
/// err  points-count  the point count differs from the vertex count
///      points-axes   ambiguous: the first frame matches the rest mesh with neither or with both axes; the user must
///      choose
ImportResult<UpAxis> find_up_axis(const PointCache& points, std::span<const glm::vec3> rest, const std::string& name);

}  // namespace sinew
