// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>

#include "runtime/assets/skin.h"
#include "runtime/jobs/influence_dispatch.h"
#include "runtime/jobs/vertex_streams.h"

namespace sinew {

/// Influences of a tile of vertices. Vertices beyond the last repeat it.
template <int kCount>
struct TileInfluences {
  VertexJoints<kCount> first;
  std::size_t last;

  VertexJoints<kCount> at(std::size_t k) const noexcept {
    const std::size_t skip = std::min(k, last) * first.count();
    return {first.joints + skip, first.weights + skip, first.runtime_count};
  }
};

/// Where the attributes of a tile begin; nullptr = not wanted.
struct TileInput {
  const glm::vec3* positions;
  const glm::vec3* normals;
  const glm::vec4* tangents;
};
struct TileOutput {
  glm::vec3* positions;
  glm::vec3* normals;
  glm::vec4* tangents;
};

/// Runs `tile(in, out)` on a tile that is not full through copies, so that nothing is read or written beyond the arrays.
template <std::size_t kSize, bool kNormals, bool kTangents, class Tile>
void run_on_copies(const Tile& tile, const TileInput& in, const TileOutput& out, std::size_t count) noexcept {
  glm::vec3 positions[kSize + 2] = {}, normals[kSize + 2] = {}, out_positions[kSize], out_normals[kSize];
  glm::vec4 tangents[kSize] = {}, out_tangents[kSize];
  std::copy_n(in.positions, count, positions);
  if constexpr (kNormals) std::copy_n(in.normals, count, normals);
  if constexpr (kTangents) std::copy_n(in.tangents, count, tangents);
  tile(TileInput{positions, normals, tangents}, TileOutput{out_positions, out_normals, out_tangents});
  std::copy_n(out_positions, count, out.positions);
  if constexpr (kNormals) std::copy_n(out_normals, count, out.normals);
  if constexpr (kTangents) std::copy_n(out_tangents, count, out.tangents);
}

/// Cuts a group into tiles of kSize vertices and calls `tile(TileInfluences, TileInput, TileOutput)` for each. A tile may read
/// two vertices beyond its own, therefore the last one goes through copies.
template <int kCount, std::size_t kSize, bool kNormals, bool kTangents, class Tile>
void for_each_tile(const VertexInfluences& influences, const InfluenceGroup& group, const VertexInput& in, const VertexOutput& out,
                   const Tile& tile) noexcept {
  const std::size_t count = group.vertex_count;
  for (std::size_t v = 0; v < count; v += kSize) {
    const std::size_t at = group.first_vertex + v, left = count - v;
    const TileInfluences<kCount> joints{joints_of<kCount>(influences, group, v), std::min(left, kSize) - 1};
    const TileInput from{in.positions.data() + at, kNormals ? in.normals.data() + at : nullptr, kTangents ? in.tangents.data() + at : nullptr};
    const TileOutput to{out.positions.data() + at, kNormals ? out.normals.data() + at : nullptr, kTangents ? out.tangents.data() + at : nullptr};
    if (left >= kSize + 2)
      tile(joints, from, to);
    else
      run_on_copies<kSize, kNormals, kTangents>([&](const TileInput& i, const TileOutput& o) { tile(joints, i, o); }, from, to, std::min(left, kSize));
  }
}

}  // namespace sinew
