// SPDX-License-Identifier: MIT
// The order of lanes that packed vec3 are fastest to load and store in, for vertices that follow one joint.
#if defined(SINEW_LANE_ORDER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_LANE_ORDER_INL_H_
#undef SINEW_LANE_ORDER_INL_H_
#else
#define SINEW_LANE_ORDER_INL_H_
#endif

#include "runtime/deform/simd/lane_memory-inl.h"
#include "runtime/deform/simd/triples-inl.h"

#if HWY_TARGET != HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// The order of triples-inl.h needs fewer shuffles across lanes. With four lanes the order is that of
/// lane_memory-inl.h: SSE instructions overwrite an operand, so triples would copy too much.
constexpr bool kInTriples = kTileSize > 4;

constexpr std::size_t vertex_of_ordered_lane(std::size_t lane) {
  return kInTriples ? vertex_of_triple_lane(lane) : vertex_of_lane(lane);
}

HWY_INLINE Lanes3 load_ordered(const glm::vec3* tile) {
  if constexpr (kInTriples)
    return lanes_of(load_triples(tile));
  else
    return load3(tile);
}

HWY_INLINE void store_ordered(const Lanes3& v, glm::vec3* tile, bool past_caches) {
  if constexpr (kInTriples)
    store_triples(triples_of(v), tile, past_caches);
  else
    store3(v, tile);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // HWY_TARGET
#endif
