// SPDX-License-Identifier: MIT
// Splits groups into rows for all kernels. It is longer than most kernels, so it is compiled once.
#if defined(SINEW_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_ROWS_INL_H_
#undef SINEW_ROWS_INL_H_
#else
#define SINEW_ROWS_INL_H_
#endif

#include <algorithm>

#include "runtime/deform/simd/vertex_tiles-inl.h"
#include "runtime/deform/simd/widened_influences-inl.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

HWY_NOINLINE void for_each_row(const InfluenceStreams& influences, const InfluenceGroup& group, const VertexInput& in,
                               const VertexOutput& out, const RowKernel& kernel, const NonTemporalStores& streamed) {
  const AttributesPresent wanted = present(in, out);
  const bool is_wide = influences.is_wide();
  const std::size_t stride = group.influence_count;
  const TileInput all_in{in.positions.data(), wanted.normals ? in.normals.data() : nullptr,
                         wanted.tangents ? in.tangents.data() : nullptr};
  const TileOutput all_out{out.positions.data(), wanted.normals ? out.normals.data() : nullptr,
                           wanted.tangents ? out.tangents.data() : nullptr};
  WidenedInfluences widened;
  TileCopies copies;
  std::size_t done = 0;
  for (std::size_t v = 0; v < group.vertex_count; v += done) {
    const bool whole = group.vertex_count >= kTileSize;
    if (whole) v = std::min(v, group.vertex_count - kTileSize);
    const std::size_t at = group.first_vertex + v, left = group.vertex_count - v;
    std::size_t tiles = whole ? left / kTileSize : 1;
    if (whole && !is_wide) tiles = std::clamp<std::size_t>(tiles, 1, WidenedInfluences::tiles_at_once(stride));
    done = whole ? tiles * kTileSize : TileCopies::has_room(stride) ? std::min(left, kTileSize) : 1;
    if (tiles > 1 && streamed.until(at) > 0) {
      tiles = 1;
      done = streamed.until(at);
    }
    const bool past_caches = whole && streamed.begins_at(at);
    const std::size_t first = group.first_influence + v * stride, widen = whole ? tiles * kTileSize : done;
    TileInfluences<0> joints{widened.of(influences, first, widen, stride), stride};
    TileInput from = all_in.from(at);
    const TileOutput to = all_out.from(at);
    if (!whole) {
      joints = copies.load(joints.first, done);
      from = copies.load(from, done);
    }
    kernel.call(kernel.context, {{at, std::min(done, kTileSize), whole},
                                 tiles,
                                 past_caches,
                                 joints,
                                 from,
                                 whole ? to : copies.in_place_of(to)});
    if (!whole) copies.store(to, done);
  }
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
