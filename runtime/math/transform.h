// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/affine.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// Translation, rotation and scale of a joint in its parent's space; the matrix is T * R * S.
template <class T>
struct TransformT {
  Vec3<T> translation{T(0)};
  Quat<T> rotation{T(1), T(0), T(0), T(0)};  // w x y z
  Vec3<T> scale{T(1)};

  friend bool operator==(const TransformT&, const TransformT&) = default;
};

using Transform = TransformT<float>;
using Transformd = TransformT<double>;

/// Matrix of a transform.
/// eq   M = T(t) * R(q) * S(s)   (glTF 2.0, "Transformations"; R by Real-Time Rendering eq. 4.46, q must be unit)
template <class T>
AffineT<T> affine_from_transform(const TransformT<T>& local) noexcept {
  const auto& q = local.rotation;
  const T xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const T xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const T wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  const auto& s = local.scale;
  const auto& t = local.translation;
  return {{{(T(1) - T(2) * (yy + zz)) * s.x, T(2) * (xy - wz) * s.y, T(2) * (xz + wy) * s.z, t.x},
           {T(2) * (xy + wz) * s.x, (T(1) - T(2) * (xx + zz)) * s.y, T(2) * (yz - wx) * s.z, t.y},
           {T(2) * (xz - wy) * s.x, T(2) * (yz + wx) * s.y, (T(1) - T(2) * (xx + yy)) * s.z, t.z}}};
}

}  // namespace sinew
