// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/deform/skin_linear.h"
#include "runtime/deform/vertex_tiles.h"

namespace sinew {

/// Linear-blend skinning of vertices that were sorted into tiles: the same result as SkinLinearJob up to rounding, in
/// about half of the time.
/// eq   M = B + sum(w_i * (palette[joint_i] - B)) over all joints of the run but the last;  p' = M p
///      B is the matrix of the last joint, whose weight is not stored (TileRun). Normals and tangents are as in
///      SkinLinearJob.
/// in   tiles    of the primitive;   palette[N]  finite
///      morphed  attributes that replace those of the tiles (MorphTilesJob); an empty one is read from the tiles
/// out  out      in the order of the primitive; must not overlap the input. A normal that collapses to zero keeps its
///      input value.
/// err  size_mismatch, index_out_of_range
/// cost O(V * influences), no allocation. The error of a position is a few units in the last place of the largest
///      |palette[joint_i] p| of its joints. `past_caches` and outputs of 8 MiB and more are as in SkinLinearJob.
struct SkinTilesJob {
  const VertexTiles* tiles = nullptr;
  std::span<const JointMatrix> palette;
  VertexOutput out;
  NormalRule normal_rule = NormalRule::linear;
  bool past_caches = false;
  TiledInput morphed;

  /// The attributes that the job reads.
  TiledInput input() const noexcept {
    const auto chosen = [](std::span<const TilePlane> own, std::span<const TilePlane> other) {
      return other.empty() ? own : other;
    };
    return {.positions = chosen(tiles->positions, morphed.positions),
            .normals = chosen(tiles->normals, morphed.normals),
            .tangents = chosen(tiles->tangents, morphed.tangents)};
  }
  /// An attribute is written if the tiles have it and there is room for it.
  bool writes_normals() const noexcept { return !out.normals.empty() && !tiles->normals.empty(); }
  bool writes_tangents() const noexcept { return !out.tangents.empty() && !tiles->tangents.empty(); }
};

SINEW_API ErrorCode check(const SkinTilesJob& job) noexcept;
SINEW_API void run_unchecked(const SkinTilesJob& job) noexcept;

}  // namespace sinew
