// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "runtime/model/mesh.h"

namespace sinew::tool {

inline constexpr std::size_t kAllVertices = std::numeric_limits<std::size_t>::max();

/// Which vertices of a primitive are written: at most `limit` vertices of the file, spread evenly. Vertices that the
/// import split, for example for flat normals, stand for one vertex of the file and are written once.
struct VertexChoice {
  struct Influences {
    std::uint32_t first = 0, count = 0;
  };  ///< into VertexInfluences::joints

  std::vector<std::uint32_t> in_file;       ///< vertex numbers of the file, increasing
  std::vector<std::uint32_t> in_primitive;  ///< parallel: the vertex with its deformed values
  std::vector<Influences> influences;       ///< parallel, empty without a skin
};

/// Chooses the vertices of a primitive.
/// cost O(V log V)
VertexChoice choose_vertices(const Primitive& primitive, std::size_t limit);

}  // namespace sinew::tool
