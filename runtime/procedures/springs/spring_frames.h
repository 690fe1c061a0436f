// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "runtime/math/affine.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/math/normal_transform.h"
#include "runtime/math/quaternion.h"
#include "runtime/math/rotation_between.h"

namespace sinew::springs {

using Vec = Vec3<double>;
using Rot = Quat<double>;
using Mat = Mat3<double>;

inline double dot(const Vec& a, const Vec& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Unit vector along v, or `fallback` if v is too short to have a direction.
inline Vec direction_of(const Vec& v, const Vec& fallback) noexcept {
  const double square = dot(v, v);
  return square > 1e-200 ? v * (1.0 / std::sqrt(square)) : fallback;
}

/// World transform that colliders hang on, at the time of a tick.
struct MatrixFrame {
  Vec at;
  Mat linear;

  Vec vector(const Vec& v) const noexcept { return linear * v; }
  Vec point(const Vec& p) const noexcept { return at + linear * p; }
  Vec normal(const Vec& n) const noexcept {
    const Mat cof = cofactor(linear);
    return direction_of(cof * n * (dot(linear[0], cof[0]) < 0.0 ? -1.0 : 1.0), n);
  }
};

}  // namespace sinew::springs
