// SPDX-License-Identifier: MIT
// Splits groups of vertices into tiles of as many vertices as a vector has lanes.
#if defined(SINEW_VERTEX_TILES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_VERTEX_TILES_INL_H_
#undef SINEW_VERTEX_TILES_INL_H_
#else
#define SINEW_VERTEX_TILES_INL_H_
#endif

#include "runtime/deform/simd/non_temporal_stores-inl.h"
#include "runtime/deform/simd/tile_memory-inl.h"
#include "runtime/deform/vertex_checks.h"
#include "runtime/deform/vertex_streams.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Vertices of a tile. An incomplete tile (`whole` is false) is padded with copies of its last vertex.
struct TilePlace {
  std::size_t first_vertex, count;
  bool whole;
};

/// `tile_count` tiles of consecutive vertices.
template <int kCount>
struct TileRow {
  TilePlace place;
  std::size_t tile_count;
  bool past_caches;
  TileInfluences<kCount> all_joints;
  TileInput all_in;
  TileOutput all_out;

  HWY_INLINE TileInfluences<kCount> joints(std::size_t tile) const {
    return {all_joints.at(tile * kTileSize), all_joints.runtime_stride};
  }
  /// The same row for a kernel that is compiled for `kOther` influences.
  template <int kOther>
  HWY_INLINE TileRow<kOther> with_count() const {
    const VertexJoints<kCount>& first = all_joints.first;
    return {place,       tile_count,
            past_caches, {{first.joints, first.weights, first.runtime_count}, all_joints.runtime_stride},
            all_in,      all_out};
  }

  HWY_INLINE TileInput in(std::size_t tile) const { return all_in.from(tile * kTileSize); }
  HWY_INLINE TileOutput out(std::size_t tile) const { return all_out.from(tile * kTileSize); }

  // Normals and tangents of a tile, for callers that know that the attribute exists.
  HWY_INLINE const glm::vec3* normals_in(std::size_t tile) const { return all_in.normals + tile * kTileSize; }
  HWY_INLINE const glm::vec4* tangents_in(std::size_t tile) const { return all_in.tangents + tile * kTileSize; }
  HWY_INLINE glm::vec3* normals_out(std::size_t tile) const { return all_out.normals + tile * kTileSize; }
  HWY_INLINE glm::vec4* tangents_out(std::size_t tile) const { return all_out.tangents + tile * kTileSize; }
};

/// Number of influences that a kernel is compiled for; 0 = any number. Each kernel takes a third of a second to
/// compile. So rare kernels, and all kernels of the scalar target, use 0 for two influences and more.
template <int kCount, bool kRare>
constexpr int kKernelCount = kCount != 1 && (kRare || HWY_TARGET == HWY_SCALAR) ? 0 : kCount;

/// A kernel for rows of tiles, and its context. All kernels share one compiled for_each_row(), which is longer than
/// most kernels.
struct RowKernel {
  const void* context;
  void (*call)(const void* context, const TileRow<0>& row);
};

/// Calls the kernel with copies of itself and of the row. No store can change the copies, so loops over tiles keep them
/// in registers. With kCount = 0 no registers are left, so the row is not copied.
template <int kCount, class Skin>
void skin_row(const void* context, const TileRow<0>& row) {
  const Skin skin = *static_cast<const Skin*>(context);
  if constexpr (kCount > 0)
    skin(row.with_count<kCount>());
  else
    skin(row);
}

/// Calls the kernel for all vertices of a group. Vertices after the last whole tile form a tile that ends with the
/// group. It skins some vertices again, with the same result. With non-temporal stores, vertices before the first
/// aligned vertex are handled the same way. A group smaller than a tile goes through copies.
/// Defined in rows-inl.h, which one source includes.
void for_each_row(const InfluenceStreams& influences, const InfluenceGroup& group, const VertexInput& in,
                  const VertexOutput& out, const RowKernel& kernel, const NonTemporalStores& streamed);

/// Same, for a function object `skin(TileRow)`.
template <int kCount, class Skin>
void for_each_row(const InfluenceStreams& influences, const InfluenceGroup& group, const VertexInput& in,
                  const VertexOutput& out, const Skin& skin, const NonTemporalStores& streamed = {}) {
  for_each_row(influences, group, in, out, RowKernel{&skin, &skin_row<kCount, Skin>}, streamed);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
