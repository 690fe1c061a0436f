// SPDX-License-Identifier: MIT
#include "runtime/deform/tiled_morphs.h"

#include <algorithm>

namespace sinew {
namespace {

/// The lanes that hold each vertex: the first of them, and spare lanes at the end of its run that repeat it.
class LanesOfVertices {
 public:
  explicit LanesOfVertices(const VertexTiles& tiles) : vertices_(tiles.vertices), first_(tiles.vertex_count) {
    for (std::size_t lane = vertices_.size(); lane-- > 0;) first_[vertices_[lane]] = static_cast<std::uint32_t>(lane);
  }
  std::uint32_t tile_of(std::uint32_t vertex) const noexcept { return first_[vertex] / VertexTiles::kLanes; }

  /// Calls `body(lane of the tile)` for all lanes of a vertex.
  template <class Body>
  void for_each(std::uint32_t vertex, const Body& body) const {
    const std::size_t first = first_[vertex] % VertexTiles::kLanes, begin = first_[vertex] - first;
    for (std::size_t lane = first; lane < VertexTiles::kLanes && vertices_[begin + lane] == vertex; ++lane) body(lane);
  }

 private:
  const std::vector<std::uint32_t>& vertices_;
  std::vector<std::uint32_t> first_;
};

TiledDeltas tile_deltas(const SparseDeltas<glm::vec3>& sparse, const LanesOfVertices& lanes) {
  TiledDeltas tiled;
  for (const std::uint32_t vertex : sparse.vertices) tiled.tiles.push_back(lanes.tile_of(vertex));
  std::sort(tiled.tiles.begin(), tiled.tiles.end());
  tiled.tiles.erase(std::unique(tiled.tiles.begin(), tiled.tiles.end()), tiled.tiles.end());
  tiled.tiles.shrink_to_fit();
  tiled.planes.resize(3 * tiled.tiles.size());
  for (std::size_t i = 0; i < sparse.vertices.size(); ++i) {
    const std::uint32_t vertex = sparse.vertices[i];
    const auto tile = std::lower_bound(tiled.tiles.begin(), tiled.tiles.end(), lanes.tile_of(vertex));
    TilePlane* const planes = &tiled.planes[3 * static_cast<std::size_t>(tile - tiled.tiles.begin())];
    lanes.for_each(vertex, [&](std::size_t lane) {
      for (int c = 0; c < 3; ++c) planes[c].lane[lane] = sparse.deltas[i][c];
    });
  }
  return tiled;
}

}  // namespace

TiledMorphs tile_morphs(const MorphSet& morphs, const VertexTiles& tiles) {
  const LanesOfVertices lanes(tiles);
  TiledMorphs tiled;
  std::size_t deltas = 0, planes = 0;
  for (const MorphTarget& target : morphs.targets) {
    TiledTarget& to = tiled.targets.emplace_back();
    const auto add = [&](const SparseDeltas<glm::vec3>& from, bool wanted, TiledDeltas& attribute) {
      if (!wanted) return;
      attribute = tile_deltas(from, lanes);
      deltas += from.vertices.size();
      planes += attribute.planes.size();
    };
    add(target.positions, true, to.positions);
    add(target.normals, !tiles.normals.empty(), to.normals);
    add(target.tangents, !tiles.tangents.empty(), to.tangents);
  }
  constexpr std::size_t kSparse = sizeof(glm::vec3) + sizeof(std::uint32_t);
  if (deltas > 0)
    tiled.relative_memory = static_cast<double>(planes * sizeof(TilePlane)) / static_cast<double>(deltas * kSparse);
  return tiled;
}

}  // namespace sinew
