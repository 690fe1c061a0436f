// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <utility>

#include "runtime/model/mesh.h"

namespace sinew::test {

/// The directed edges of all triangles, with the number of triangles that have each.
inline std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const Primitive& primitive) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < primitive.indices.size(); i += 3)
    for (std::size_t c = 0; c < 3; ++c) ++edges[{primitive.indices[i + c], primitive.indices[i + (c + 1) % 3]}];
  return edges;
}

/// Counts the directed edges whose opposite edge does not occur as often. A closed surface has none.
inline std::size_t open_edges(const Primitive& primitive) {
  const auto edges = directed_edges(primitive);
  std::size_t open = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (back == edges.end() || back->second != count) ++open;
  }
  return open;
}

/// eq   vertices - edges + triangles: 2 for a sphere, 0 for a torus; for two surfaces the sum
inline long euler_number(const Primitive& primitive) {
  return static_cast<long>(primitive.positions.size()) - static_cast<long>(directed_edges(primitive).size() / 2) +
         static_cast<long>(primitive.indices.size() / 3);
}

}  // namespace sinew::test
