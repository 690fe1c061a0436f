// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>

#include "runtime/model/scene.h"

namespace sinew::tool {

/// What a skin moves, over all meshes that nodes hang on it, each mesh once.
struct SkinStatistics {
  std::map<std::uint32_t, std::uint64_t>
      vertices_by_influences;            ///< vertices of the file with each number of influences
  std::uint64_t joints_with_weight = 0;  ///< joints that move a vertex
};

SkinStatistics skin_statistics(const Scene& scene, std::uint32_t skin);

/// Vertices of a primitive in the file: copies that the importer made count once.
std::uint64_t file_vertex_count(const Primitive& primitive);

}  // namespace sinew::tool
