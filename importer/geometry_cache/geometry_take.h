// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew {

/// One vertex attribute of a mesh over all frames.
struct TakeStream {
  GeometryKind kind = GeometryKind::positions;
  std::vector<std::vector<glm::vec3>> frames;  ///< [frames][vertices] values in each frame
  double budget =
      1e-4;  ///< largest error of a decoded value: metres for positions, vector length for normals and colours
};

struct TakeMesh {
  std::string name;
  std::uint32_t vertex_count = 0;
  std::vector<std::uint32_t> triangles;  ///< same for all frames; may be empty
  std::vector<TakeStream> streams;       ///< positions, then normals and colours if present
  /// [frames - 1][vertices] true positions halfway between frames, to measure interpolation errors; empty = unknown.
  std::vector<std::vector<glm::vec3>> between;
};

/// Input of a geometry cache: meshes with constant topology and independently moving vertices.
struct GeometryTake {
  std::vector<TakeMesh> meshes;
  double start_s = 0.0, frame_s = 1.0 / 30.0;
};

}  // namespace sinew
