// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"
#include "runtime/math/perpendicular.h"

namespace sinew {

/// View matrix of an eye that looks along -z of its own frame: right-handed, world to view space.
/// eq   rows r, u, v of the frame v = eye - target, r = up x v, u = v x r, each unit; translation -(frame eye)
///      (Real-Time Rendering, eqs. 4.18, 4.19). Eye at the target: looks along -z of the world; `up` along the view:
///      any up square to it
template <class T>
AffineT<T> look_at(const Vec3<T>& eye, const Vec3<T>& target, const Vec3<T>& up) noexcept {
  const Vec3<T> none(T(0)), v = normalised_or(eye - target, Vec3<T>(T(0), T(0), T(1)));
  const Vec3<T> side = glm::cross(normalised_or(up, none), v);
  // A sine below 1e-6 is rounding of the inputs: its direction would be noise.
  const Vec3<T> r = square_of(side) > T(1e-12) ? normalised_or(side, none) : perpendicular_to(v), u = glm::cross(v, r);
  AffineT<T> m;
  const Vec3<T> rows[3] = {r, u, v};
  for (int i = 0; i < 3; ++i) m.row[i] = {rows[i].x, rows[i].y, rows[i].z, -glm::dot(rows[i], eye)};
  return m;
}

}  // namespace sinew
