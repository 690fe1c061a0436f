// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/conventions.h"

namespace sinew {

/// A 3x4 affine matrix: three rows, the fourth (0 0 0 1) is implied. `row[r][3]` is the translation.
template <class T>
struct AffineT {
  Vec4<T> row[3] = {{T(1), T(0), T(0), T(0)}, {T(0), T(1), T(0), T(0)}, {T(0), T(0), T(1), T(0)}};

  friend bool operator==(const AffineT&, const AffineT&) = default;
};

using Affine = AffineT<float>;
using Affined = AffineT<double>;

/// Product of two affine matrices.
/// eq   C = A * B: B is applied first. Each row is summed in the order x, y, z, translation.
template <class T>
AffineT<T> operator*(const AffineT<T>& a, const AffineT<T>& b) noexcept {
  AffineT<T> c;
  for (int r = 0; r < 3; ++r) {
    c.row[r] = a.row[r].x * b.row[0] + a.row[r].y * b.row[1] + a.row[r].z * b.row[2];
    c.row[r].w += a.row[r].w;
  }
  return c;
}

/// Transforms a point, by the whole matrix.
/// eq   p' = M * (p, 1)
template <class T>
Vec3<T> transform_point(const AffineT<T>& m, const Vec3<T>& p) noexcept {
  const auto component = [&](const Vec4<T>& r) { return r.x * p.x + r.y * p.y + r.z * p.z + r.w; };
  return {component(m.row[0]), component(m.row[1]), component(m.row[2])};
}

/// Transforms a direction or a difference, by the linear part only.
/// eq   v' = M * (v, 0)
template <class T>
Vec3<T> transform_vector(const AffineT<T>& m, const Vec3<T>& v) noexcept {
  const auto component = [&](const Vec4<T>& r) { return r.x * v.x + r.y * v.y + r.z * v.z; };
  return {component(m.row[0]), component(m.row[1]), component(m.row[2])};
}

template <class T>
Vec3<T> translation_of(const AffineT<T>& m) noexcept {
  return {m.row[0].w, m.row[1].w, m.row[2].w};
}

/// The linear part as GLM's column-major 3x3.
template <class T>
Mat3<T> linear_part(const AffineT<T>& m) noexcept {
  return {m.row[0].x, m.row[1].x, m.row[2].x, m.row[0].y, m.row[1].y, m.row[2].y, m.row[0].z, m.row[1].z, m.row[2].z};
}

template <class T>
AffineT<T> affine_from(const Mat3<T>& linear, const Vec3<T>& translation) noexcept {
  AffineT<T> m;
  for (int r = 0; r < 3; ++r) m.row[r] = {linear[0][r], linear[1][r], linear[2][r], translation[r]};
  return m;
}

/// GLM's column-major 4x4 with the implied fourth row written out.
template <class T>
Mat4<T> mat4_from_affine(const AffineT<T>& m) noexcept {
  Mat4<T> out(T(1));
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r) out[c][r] = m.row[r][c];
  return out;
}

template <class To, class From>
AffineT<To> affine_cast(const AffineT<From>& m) noexcept {
  return {{Vec4<To>(m.row[0]), Vec4<To>(m.row[1]), Vec4<To>(m.row[2])}};
}

/// Determinant of the linear part, with rounding errors. Use determinant_sign for an exact sign.
template <class T>
T determinant(const AffineT<T>& m) noexcept {
  const auto &a = m.row[0], &b = m.row[1], &c = m.row[2];
  return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
}

}  // namespace sinew
