// SPDX-License-Identifier: MIT
// Collisions of tails, one joint per lane. Included once per SIMD target, so without `#pragma once`.
#if defined(SINEW_SPRING_COLLISIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_SPRING_COLLISIONS_INL_H
#undef SINEW_SPRING_COLLISIONS_INL_H
#else
#define SINEW_SPRING_COLLISIONS_INL_H
#endif

#include "runtime/procedures/springs/spring_lanes-inl.h"
#include "runtime/procedures/springs/spring_memory.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Head, direction and length of bones whose joints are at their goals.
template <class D>
struct Bones {
  Vector<D> head, axis;
  hn::Vec<D> length;
};

template <class D>
HWY_INLINE Vector<D> same_in_all_lanes(D d, const springs::Vec& v) {
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

/// Moves tails out of a shape, or into it for inside colliders.
/// in   away  direction to take for a tail exactly at the centre
/// out  returns the lanes whose tail was moved
template <class D>
HWY_INLINE hn::Mask<D> push_out(D d, const springs::WorldShape& shape, hn::Vec<D> hit_radius, const Vector<D>& away,
                                hn::Mask<D> lanes, Vector<D>& tail) {
  const hn::Vec<D> zero = hn::Zero(d), radius = hn::Set(d, shape.radius);
  const Vector<D> along = same_in_all_lanes(d, shape.along);
  Vector<D> from = minus<D>(tail, same_in_all_lanes(d, shape.at));
  if (shape.kind == SpringCollider::Kind::plane) {
    const hn::Vec<D> depth = hn::Sub(hit_radius, dot<D>(from, along));
    const hn::Mask<D> hits = hn::And(lanes, hn::Gt(depth, zero));
    tail = plus<D>(tail, times<D>(along, hn::IfThenElseZero(hits, depth)));
    return hits;
  }
  if (shape.inverse != 0.0) {
    const hn::Vec<D> part = hn::Mul(dot<D>(from, along), hn::Set(d, shape.inverse));
    from = minus<D>(from, times<D>(along, hn::Min(hn::Max(part, zero), hn::Set(d, 1.0))));
  }
  const hn::Vec<D> square = dot<D>(from, from);
  const hn::Vec<D> limit = shape.inside ? hn::Sub(radius, hit_radius) : hn::Add(radius, hit_radius);
  const hn::Vec<D> most = hn::Mul(limit, limit);
  const hn::Mask<D> is_free = shape.inside ? hn::And(hn::Ge(limit, zero), hn::Le(square, most)) : hn::Ge(square, most);
  const hn::Mask<D> hits = hn::AndNot(is_free, lanes);
  if (hn::AllFalse(d, hits)) return hits;
  const Vector<D> out = direction_or<D>(d, from, away);
  tail = plus<D>(tail, times<D>(out, hn::IfThenElseZero(hits, hn::Sub(limit, hn::Sqrt(square)))));
  return hits;
}

/// Moves tails out of all colliders of their groups, in the order of each group. After each collider, the distance of
/// a moved tail from the head is restored.
/// in   groups  of the joints; `lanes` are the joints that swing
/// out  along   unit direction from the head to the tail
template <class D>
HWY_INLINE void keep_out(D d, const SpringTables& tables, std::span<const springs::WorldShape> shapes,
                         hn::Vec<D> groups, hn::Mask<D> lanes, hn::Vec<D> hit_radius, const Bones<D>& bones,
                         Vector<D>& along, Vector<D>& tail) {
  for (std::intptr_t lane = hn::FindFirstTrue(d, lanes); lane >= 0; lane = hn::FindFirstTrue(d, lanes)) {
    HWY_ALIGN double all[springs::kSpringLanes];
    hn::Store(groups, d, all);
    const hn::Mask<D> mine = hn::And(lanes, hn::Eq(groups, hn::Set(d, all[lane])));
    const SpringGroupRecord& group = tables.groups[static_cast<std::size_t>(all[lane])];
    for (std::uint32_t i = 0; i < group.collider_count; ++i) {
      const springs::WorldShape& shape = shapes[tables.collider_lists[group.first_collider + i]];
      const hn::Mask<D> hits = push_out(d, shape, hit_radius, bones.axis, mine, tail);
      if (hn::AllFalse(d, hits)) continue;
      along = either<D>(hits, direction_or<D>(d, minus<D>(tail, bones.head), bones.axis), along);
      tail = either<D>(hits, plus<D>(bones.head, times<D>(along, bones.length)), tail);
    }
    lanes = hn::AndNot(mine, lanes);
  }
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
