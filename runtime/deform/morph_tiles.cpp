// SPDX-License-Identifier: MIT
#include "runtime/deform/morph_tiles.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "runtime/deform/morph_tiles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "runtime/deform/morph_vertices.h"
#include "runtime/deform/sparse_range.h"
#include "runtime/pose/simd/dispatch.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

using TileFloats = hn::CappedTag<float, VertexTiles::kLanes>;

/// Tiles are summed and finished in chunks of this size, so that their sums stay in the first-level cache.
constexpr std::size_t kChunkTiles = 64;

// Nothing is fused, so all targets give the same sums.

HWY_INLINE void add_plane(const TilePlane& a, const TilePlane& b, TilePlane& to) {
  const TileFloats d;
  for (std::size_t i = 0; i < VertexTiles::kLanes; i += hn::Lanes(d))
    hn::Store(hn::Add(hn::Load(d, &a.lane[i]), hn::Load(d, &b.lane[i])), d, &to.lane[i]);
}
HWY_INLINE void add_product(const TilePlane& delta, hn::Vec<TileFloats> weight, TilePlane& sum) {
  const TileFloats d;
  for (std::size_t i = 0; i < VertexTiles::kLanes; i += hn::Lanes(d))
    hn::Store(hn::Add(hn::Load(d, &sum.lane[i]), hn::Mul(hn::Load(d, &delta.lane[i]), weight)), d, &sum.lane[i]);
}

void add_deltas(const TiledDeltas& deltas, float weight, std::size_t first, std::size_t count, TilePlane* sums) {
  const auto weights = hn::Set(TileFloats(), weight);
  const SparseRange range = sparse_range(deltas.tiles, first, count);
  for (std::size_t i = range.begin; i < range.end; ++i) {
    TilePlane* const sum = sums + 3 * (deltas.tiles[i] - first);
    for (std::size_t c = 0; c < 3; ++c) add_product(deltas.planes[3 * i + c], weights, sum[c]);
  }
}

/// Morphs one attribute, which has 3 or 4 planes a tile; the fourth is copied.
void morph_planes(const MorphTilesJob& job, TiledDeltas TiledTarget::*attribute, std::size_t per_tile,
                  std::span<const TilePlane> from, std::span<TilePlane> to) {
  if (to.empty()) return;
  TilePlane sums[3 * kChunkTiles];
  const std::size_t tiles = job.tiles->tile_count();
  for (std::size_t first = 0; first < tiles; first += kChunkTiles) {
    const std::size_t count = std::min(kChunkTiles, tiles - first);
    std::fill_n(sums, 3 * count, TilePlane{});
    for (std::size_t t = 0; t < job.morphs->targets.size(); ++t)
      if (is_active_weight(job.weights[t]))
        add_deltas(job.morphs->targets[t].*attribute, job.weights[t], first, count, sums);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t tile = (first + i) * per_tile;
      for (std::size_t c = 0; c < 3; ++c) add_plane(from[tile + c], sums[3 * i + c], to[tile + c]);
      if (per_tile == 4) to[tile + 3] = from[tile + 3];
    }
  }
}

void morph_tiles(const MorphTilesJob& job) {
  const TiledInput in = attributes_of(*job.tiles);
  morph_planes(job, &TiledTarget::positions, 3, in.positions, job.out.positions);
  morph_planes(job, &TiledTarget::normals, 3, in.normals, job.out.normals);
  morph_planes(job, &TiledTarget::tangents, 4, in.tangents, job.out.tangents);
}

}  // namespace
}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {
namespace {

bool lie_in(const TiledDeltas& deltas, std::size_t tile_count) noexcept {
  return deltas.planes.size() == 3 * deltas.tiles.size() &&
         (deltas.tiles.empty() || deltas.tiles.back() < tile_count);  // tiles increase
}

}  // namespace

ErrorCode check(const MorphTilesJob& job) noexcept {
  if (!job.tiles || !job.morphs || job.weights.size() < job.morphs->targets.size()) return ErrorCode::size_mismatch;
  if (!have_memory(job.weights, job.out.positions, job.out.normals, job.out.tangents)) return ErrorCode::size_mismatch;
  const TiledInput in = attributes_of(*job.tiles);
  const auto fits = [](std::span<const TilePlane> from, std::span<TilePlane> to) {
    return to.empty() || (to.size() >= from.size() && !from.empty());
  };
  if (!fits(in.positions, job.out.positions) || !fits(in.normals, job.out.normals) ||
      !fits(in.tangents, job.out.tangents))
    return ErrorCode::size_mismatch;
  for (const TiledTarget& target : job.morphs->targets)
    for (const TiledDeltas* deltas : {&target.positions, &target.normals, &target.tangents})
      if (!lie_in(*deltas, job.tiles->tile_count())) return ErrorCode::index_out_of_range;
  for (const float weight : job.weights)
    if (!std::isfinite(weight)) return ErrorCode::not_finite;
  return ErrorCode::ok;
}

SINEW_DISPATCH_RUN(MorphTilesJob, morph_tiles)

}  // namespace sinew
#endif
