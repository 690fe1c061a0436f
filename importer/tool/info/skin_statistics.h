// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>

#include "runtime/model/scene.h"

namespace sinew::tool {

/// Counts over all meshes that nodes use with a skin; each mesh counts once.
struct SkinStatistics {
  /// How many vertices of the file have each number of influences.
  std::map<std::uint32_t, std::uint64_t> vertices_by_influences;
  std::uint64_t joints_with_weight = 0;  ///< joints that move a vertex
};

SkinStatistics skin_statistics(const Scene& scene, std::uint32_t skin);

/// Number of vertices of a primitive in the file. Copies that the importer made count once.
std::uint64_t file_vertex_count(const Primitive& primitive);

}  // namespace sinew::tool
