// SPDX-License-Identifier: MIT
// Matrices that all vertices of a tile share (shared_joints-inl.h), blended with one vertex per lane. No matrix is
// loaded or transposed per vertex. The operations are those of blend_columns-inl.h in the same order, so results have
// the same bits.
#if defined(SINEW_SHARED_MATRICES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SHARED_MATRICES_INL_H_
#undef SINEW_SHARED_MATRICES_INL_H_
#else
#define SINEW_SHARED_MATRICES_INL_H_
#endif

#include "runtime/deform/simd/lane_matrix-inl.h"
#include "runtime/deform/simd/shared_joints-inl.h"
#include "runtime/deform/simd/triples-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Order of lanes for packed vec3 of tiles whose vertices share joints. The order of triples-inl.h needs fewer shuffles
/// across lanes. With four lanes the order is that of lane_memory-inl.h: SSE instructions overwrite an operand, so
/// triples would copy too much.
constexpr bool kInTriples = kTileSize > 4;

constexpr std::size_t vertex_of_shared_lane(std::size_t lane) {
  return kInTriples ? vertex_of_triple_lane(lane) : vertex_of_lane(lane);
}

HWY_INLINE Lanes3 load_shared(const glm::vec3* tile) {
  if constexpr (kInTriples)
    return lanes_of(load_triples(tile));
  else
    return load3(tile);
}

HWY_INLINE void store_shared(const Lanes3& v, glm::vec3* tile, bool past_caches) {
  if constexpr (kInTriples)
    store_triples(triples_of(v), tile, past_caches);
  else
    store3(v, tile);
}

/// The lane of a vertex in the order of lane_memory-inl.h.
constexpr std::size_t lane_of_vertex(std::size_t vertex) {
  std::size_t lane = 0;
  while (vertex_of_lane(lane) != vertex) ++lane;
  return lane;
}

/// Permutes one number per vertex from memory order to the lane order of load_shared().
HWY_INLINE Wide shared_from_memory(Wide v) {
  if constexpr (!kInTriples) return v;
  static constexpr LaneTable kTable([](std::size_t lane) { return vertex_of_shared_lane(lane); });
  return hn::TableLookupLanes(v, hn::SetTableIndices(TileTag(), kTable.lanes));
}
/// Permutes from the lane order of lane_memory-inl.h to that of load_shared().
HWY_INLINE Wide shared_from_lanes(Wide v) {
  if constexpr (!kInTriples) return v;
  static constexpr LaneTable kTable([](std::size_t lane) { return lane_of_vertex(vertex_of_shared_lane(lane)); });
  return hn::TableLookupLanes(v, hn::SetTableIndices(TileTag(), kTable.lanes));
}
/// Permutes from the lane order of load_shared() to that of lane_memory-inl.h.
HWY_INLINE Wide lanes_from_shared(Wide v) {
  if constexpr (!kInTriples) return v;
  static constexpr LaneTable kTable([](std::size_t lane) {
    std::size_t from = 0;
    while (vertex_of_shared_lane(from) != vertex_of_lane(lane)) ++from;
    return from;
  });
  return hn::TableLookupLanes(v, hn::SetTableIndices(TileTag(), kTable.lanes));
}

HWY_INLINE WeightLanes<2> shared_weight_lanes(const TileInfluences<2>& tile) {
  WeightLanes<2> w;
  hn::LoadInterleaved2(TileTag(), tile.first.weights, w.of[0], w.of[1]);
  return {{shared_from_memory(w.of[0]), shared_from_memory(w.of[1])}};
}
HWY_INLINE WeightLanes<3> shared_weight_lanes(const TileInfluences<3>& tile) {
  const Lanes3 w = load_shared(reinterpret_cast<const glm::vec3*>(tile.first.weights));
  return {{w.x, w.y, w.z}};
}
HWY_INLINE WeightLanes<4> shared_weight_lanes(const TileInfluences<4>& tile) {
  const WeightLanes<4> w = weight_lanes(tile);
  return {
      {shared_from_lanes(w.of[0]), shared_from_lanes(w.of[1]), shared_from_lanes(w.of[2]), shared_from_lanes(w.of[3])}};
}

/// The matrices that the vertices of some tiles share. Without AVX, a broadcast from memory takes two instructions, but
/// a multiplication can read an operand from memory. There, each matrix entry is broadcast to memory once.
template <int kCount>
class SharedMatrices {
 public:
  static constexpr bool kSpread = kTileSize == 4 && HWY_ARCH_X86;
  static constexpr std::size_t kMinTiles = kSpread ? 2 : 1;  ///< fewest tiles that pay for the preparation

  HWY_INLINE SharedMatrices(const JointMatrix* palette, const std::uint16_t* joints) {
    for (std::size_t i = 0; i < kCount; ++i) {
      const JointMatrix& joint = palette[joints[i]];
      joint_[i] = &joint;
      if constexpr (kSpread)
        for (std::size_t c = 0; c < 4; ++c) {
          const Wide column = hn::LoadU(TileTag(), &joint.column[c].x);
          hn::Store(broadcast<0>(column), TileTag(), spread_[i][c][0]);
          hn::Store(broadcast<1>(column), TileTag(), spread_[i][c][1]);
          hn::Store(broadcast<2>(column), TileTag(), spread_[i][c][2]);
        }
    }
  }

  /// Column `c` of the blend of every vertex.
  /// eq   sum(w_i * palette[joint_i])
  HWY_INLINE Lanes3 column(std::size_t c, const WeightLanes<kCount>& weights) const {
    Lanes3 sum = times(column_of(0, c), weights.of[0]);
    for (std::size_t i = 1; i < kCount; ++i) sum = plus_product(sum, column_of(i, c), weights.of[i]);
    return sum;
  }

 private:
  HWY_INLINE Lanes3 column_of(std::size_t i, std::size_t c) const {
    const TileTag d;
    if constexpr (kSpread) {
      const auto& of = spread_[i][c];
      return {hn::Load(d, of[0]), hn::Load(d, of[1]), hn::Load(d, of[2])};
    } else {
      const glm::vec4& of = joint_[i]->column[c];
      return {hn::Set(d, of.x), hn::Set(d, of.y), hn::Set(d, of.z)};
    }
  }

  const JointMatrix* joint_[kCount];
  HWY_ALIGN float spread_[kSpread ? kCount : 1][4][3][kTileSize];
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
