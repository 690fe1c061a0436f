// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/deform/tiled_morphs.h"
#include "runtime/deform/vertex_tiles.h"

namespace sinew {

/// MorphVerticesJob for vertices in tiles, which SkinTilesJob then skins (SkinTilesJob::morphed). The sums have the
/// same bits. Directions keep their length, because skinning normalises them.
/// eq   v' = v + sum(weight[i] * delta[i])
/// in   tiles and morphs  of one primitive (tile_morphs);   weights[T]  any sign and size
/// out  planes of all tiles. An empty attribute is not wanted.
/// err  size_mismatch, index_out_of_range, not_finite     cost O(V + tiles of active targets), no allocation
struct MorphTilesJob {
  const VertexTiles* tiles = nullptr;
  const TiledMorphs* morphs = nullptr;
  std::span<const float> weights;
  TiledOutput out;
};

SINEW_API ErrorCode check(const MorphTilesJob& job) noexcept;
SINEW_API void run_unchecked(const MorphTilesJob& job) noexcept;

}  // namespace sinew
