// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "runtime/geometry_cache/geometry_cache.h"

namespace sinew {

/// One attribute of a mesh in every frame.
struct TakeStream {
  GeometryKind kind = GeometryKind::positions;
  std::vector<std::vector<glm::vec3>> frames;  ///< [frames][vertices]
  double budget =
      1e-4;  ///< largest distance of a decoded value: metres, or the length of a difference of normals or colours
};

struct TakeMesh {
  std::string name;
  std::uint32_t vertex_count = 0;
  std::vector<std::uint32_t> triangles;         ///< the same in all frames; may be empty
  std::vector<TakeStream> streams;              ///< positions, then what there is of normals and colours
  std::vector<std::vector<glm::vec3>> between;  ///< [frames - 1][vertices] positions half way between frames, where the
                                                ///< source knows them: only to measure; empty = not known
};

/// What a geometry cache is baked from: meshes that keep their topology while every vertex moves by itself.
struct GeometryTake {
  std::vector<TakeMesh> meshes;
  double start_s = 0.0, frame_s = 1.0 / 30.0;
};

}  // namespace sinew
