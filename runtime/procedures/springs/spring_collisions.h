// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <span>

#include "runtime/procedures/springs/spring_memory.h"

namespace sinew::springs {

/// Moves the shape of a collider into the world.
template <class Frame>
WorldShape world_shape(const SpringCollider& shape, const Frame& frame) noexcept {
  using Kind = SpringCollider::Kind;
  WorldShape out{shape.kind, shape.inside, frame.point(shape.offset), Vec(0.0), 0.0, shape.radius_m};
  if (shape.kind == Kind::plane) out.along = direction_of(frame.normal(shape.normal), Vec(0, 1, 0));
  if (shape.kind != Kind::capsule) return out;
  out.along = frame.vector(shape.tail - shape.offset);
  const double square = dot(out.along, out.along);
  out.inverse = square > 0.0 ? 1.0 / square : 0.0;
  return out;
}

/// Moves a tail out of a shape, or into it for inside colliders.
/// in   away  direction to take for a tail exactly at the centre
/// out  returns true if the tail was moved
inline bool push_out(const WorldShape& shape, double hit_radius, const Vec& away, Vec& tail) noexcept {
  Vec from = tail - shape.at;
  if (shape.kind == SpringCollider::Kind::plane) {
    const double depth = hit_radius - dot(from, shape.along);
    if (!(depth > 0.0)) return false;
    tail += shape.along * depth;
    return true;
  }
  if (shape.inverse != 0.0) {
    const double part = dot(from, shape.along) * shape.inverse;
    from -= shape.along * (part < 0.0 ? 0.0 : (part > 1.0 ? 1.0 : part));
  }
  const double square = dot(from, from);
  const double limit = shape.inside ? shape.radius - hit_radius : shape.radius + hit_radius;
  const bool is_free = shape.inside ? limit >= 0.0 && square <= limit * limit : square >= limit * limit;
  if (is_free) return false;
  const Vec out = direction_of(from, away);
  tail += out * (limit - std::sqrt(square));
  return true;
}

/// Head, direction and length of a bone whose joint is at its goal.
struct Bone {
  Vec head, axis;
  double length;
};

/// Moves a tail out of all colliders of its group, in their order. After each one its distance from the head is
/// restored.
/// out  along  unit direction from the head to the tail
inline void keep_out(const SpringTables& tables, std::span<const WorldShape> shapes, const SpringRecord& record,
                     const Bone& bone, Vec& along, Vec& tail) noexcept {
  const SpringGroupRecord& group = tables.groups[record.group];
  for (std::uint32_t i = 0; i < group.collider_count; ++i) {
    const WorldShape& shape = shapes[tables.collider_lists[group.first_collider + i]];
    if (!push_out(shape, record.hit_radius, bone.axis, tail)) continue;
    along = direction_of(tail - bone.head, bone.axis);
    tail = bone.head + along * bone.length;
  }
}

}  // namespace sinew::springs
