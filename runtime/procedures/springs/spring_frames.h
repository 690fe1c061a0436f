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

/// Shortest rotation between unit vectors.
/// eq   (from x to, 1 + from . to), normalised   (Real-Time Rendering, eq. 4.58); a half turn for opposite vectors
inline Rot turn_between(const Vec& from, const Vec& to) noexcept {
  const double w = 1.0 + dot(from, to);
  if (w < 1e-7) {
    const Vec a(std::abs(from.x), std::abs(from.y), std::abs(from.z));
    const Vec least = a.x <= a.y && a.x <= a.z ? Vec(1, 0, 0) : (a.y <= a.z ? Vec(0, 1, 0) : Vec(0, 0, 1));
    const Vec axis = direction_of(glm::cross(from, least), least);
    return quat_xyzw(axis.x, axis.y, axis.z, 0.0);
  }
  const Vec v = glm::cross(from, to);
  const double inverse = 1.0 / std::sqrt(dot(v, v) + w * w);
  return quat_xyzw(v.x * inverse, v.y * inverse, v.z * inverse, w * inverse);
}

/// World transform of a joint if all scales above it are uniform: position, rotation, and a signed scale factor.
struct UniformFrame {
  Vec at;
  Rot rotation;
  double scale;

  double sign() const noexcept { return scale < 0.0 ? -1.0 : 1.0; }
  Vec vector(const Vec& v) const noexcept { return rotate_vector(rotation, v) * scale; }
  Vec point(const Vec& p) const noexcept { return at + vector(p); }
  Vec normal(const Vec& n) const noexcept { return rotate_vector(rotation, n) * sign(); }

  /// Length and direction of a vector after the transform, given its own length and direction.
  double length_of(const Vec&, double length) const noexcept { return std::abs(scale) * length; }
  Vec direction_along(const Vec&, const Vec& axis) const noexcept { return normal(axis); }

  /// A vector of any length that the transform turns to the direction `v`.
  Vec local_direction(const Vec& v) const noexcept { return rotate_vector(quat_conjugate(rotation), v) * sign(); }
  Vec local_point(const Vec& p) const noexcept {
    return scale != 0.0 ? rotate_vector(quat_conjugate(rotation), p - at) * (1.0 / scale) : Vec(0.0);
  }
  UniformFrame child(const Vec& translation, const Rot& local) const noexcept {
    return {point(translation), rotation * local, scale};
  }
  UniformFrame turned(const Rot& local) const noexcept { return {at, rotation * local, scale}; }
  UniformFrame scaled(const Vec& factors) const noexcept { return {at, rotation, scale * factors.x}; }
};

/// World transform of a joint for scales of any kind. Such scales shear joints that are rotated below them.
struct MatrixFrame {
  Vec at;
  Mat linear;

  Vec vector(const Vec& v) const noexcept { return linear * v; }
  Vec point(const Vec& p) const noexcept { return at + linear * p; }
  Vec normal(const Vec& n) const noexcept {
    const Mat cof = cofactor(linear);
    return direction_of(cof * n * (dot(linear[0], cof[0]) < 0.0 ? -1.0 : 1.0), n);
  }
  double length_of(const Vec& v, double) const noexcept {
    const Vec image = vector(v);
    return std::sqrt(dot(image, image));
  }
  Vec direction_along(const Vec& v, const Vec&) const noexcept { return direction_of(vector(v), Vec(0, 1, 0)); }
  Vec local_direction(const Vec& v) const noexcept {
    const Mat cof = cofactor(linear);
    const double sign = dot(linear[0], cof[0]) < 0.0 ? -1.0 : 1.0;
    return Vec(dot(cof[0], v), dot(cof[1], v), dot(cof[2], v)) * sign;
  }
  Vec local_point(const Vec& p) const noexcept {
    const Mat cof = cofactor(linear);
    const double det = dot(linear[0], cof[0]);
    const Vec d = p - at;
    return det != 0.0 ? Vec(dot(cof[0], d), dot(cof[1], d), dot(cof[2], d)) * (1.0 / det) : Vec(0.0);
  }
  MatrixFrame child(const Vec& translation, const Rot& local) const noexcept {
    return {point(translation), linear * matrix_from_unit_quat(local)};
  }
  MatrixFrame turned(const Rot& local) const noexcept { return {at, linear * matrix_from_unit_quat(local)}; }
  MatrixFrame scaled(const Vec& factors) const noexcept {
    return {at, Mat(linear[0] * factors.x, linear[1] * factors.y, linear[2] * factors.z)};
  }
};

}  // namespace sinew::springs
