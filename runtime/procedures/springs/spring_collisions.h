// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/procedures/springs/spring_memory.h"

namespace sinew::springs {

/// Moves the shape of a collider into the world.
inline WorldShape world_shape(const SpringCollider& shape, const MatrixFrame& frame) noexcept {
  using Kind = SpringCollider::Kind;
  WorldShape out{shape.kind, shape.inside, frame.point(shape.offset), Vec(0.0), 0.0, shape.radius_m};
  if (shape.kind == Kind::plane) out.along = direction_of(frame.normal(shape.normal), Vec(0, 1, 0));
  if (shape.kind != Kind::capsule) return out;
  out.along = frame.vector(shape.tail - shape.offset);
  const double square = dot(out.along, out.along);
  out.inverse = square > 0.0 ? 1.0 / square : 0.0;
  return out;
}

}  // namespace sinew::springs
