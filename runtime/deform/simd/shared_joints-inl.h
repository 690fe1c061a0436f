// SPDX-License-Identifier: MIT
// Tiles whose vertices have the same joints but different weights. The importer orders such vertices one after another.
#if defined(SINEW_SHARED_JOINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SHARED_JOINTS_INL_H_
#undef SINEW_SHARED_JOINTS_INL_H_
#else
#define SINEW_SHARED_JOINTS_INL_H_
#endif

#include <algorithm>
#include <bit>

#include "runtime/deform/simd/lane_memory-inl.h"
#include "runtime/deform/simd/vertex_tiles-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// True for influence counts that have kernels for vertices with the same joints. One influence needs no blend; with
/// five and more, vertices rarely share all joints.
template <int kCount>
constexpr bool kMayShareJoints = kCount >= 2 && kCount <= 4;

/// True if all vertices have the same joints in the same order: each index equals the one `kCount` before it.
template <int kCount, std::size_t kVertices = kTileSize>
HWY_INLINE bool share_joints(const std::uint16_t* joints) {
  constexpr std::size_t kCompared = (kVertices - 1) * kCount;
  if (joints[0] != joints[kCompared]) return false;  // quick test, which rejects most tiles
  constexpr std::size_t kLanes = std::min(std::bit_floor(kCompared), 2 * kTileSize);
  const hn::CappedTag<std::uint16_t, kLanes> d;
  const auto same = [&](std::size_t at)
                        HWY_ATTR { return hn::Eq(hn::LoadU(d, joints + at), hn::LoadU(d, joints + at + kCount)); };
  auto all = same(kCompared - kLanes);
  for (std::size_t at = 0; at + kLanes < kCompared; at += kLanes) all = hn::And(all, same(at));
  return hn::AllTrue(d, all);
}

/// Weights of a tile, one vertex per lane.
template <int kCount>
struct WeightLanes {
  Wide of[kCount];
};

/// Loads the weights of a tile. Lanes are in the order of lane_memory-inl.h.
HWY_INLINE WeightLanes<2> weight_lanes(const TileInfluences<2>& tile) {
  WeightLanes<2> w;
  hn::LoadInterleaved2(TileTag(), tile.first.weights, w.of[0], w.of[1]);
  if constexpr (vertex_of_lane(1) != 1) {
    static constexpr LaneTable kTable([](std::size_t lane) { return vertex_of_lane(lane); });
    for (Wide& of : w.of) of = hn::TableLookupLanes(of, hn::SetTableIndices(TileTag(), kTable.lanes));
  }
  return w;
}
HWY_INLINE WeightLanes<3> weight_lanes(const TileInfluences<3>& tile) {
  const Lanes3 w = load3(reinterpret_cast<const glm::vec3*>(tile.first.weights));
  return {{w.x, w.y, w.z}};
}
HWY_INLINE WeightLanes<4> weight_lanes(const TileInfluences<4>& tile) {
  const Lanes4 w = load4(reinterpret_cast<const glm::vec4*>(tile.first.weights));
  return {{w.x, w.y, w.z, w.w}};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
