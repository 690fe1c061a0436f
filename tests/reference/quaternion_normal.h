// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/quaternion.h"

namespace sinew::reference {

// Interpolation of normals as quaternions (Hast 2005), as viewer/shaders/quaternion_normal.glsl does when the viewer's
// option is on. Each normal is represented by the unit vector half way between it and the axis +z. The interpolated
// normal has unit length without slerp. Its path leaves the great arc, and the more so the nearer the normals are to
// -z.

/// The unit vector half way between n and +z.
/// eq   q = (n.x / 2z, n.y / 2z, z), z = sqrt((n.z + 1) / 2)   (Hast 2005, eq. 16). Below the equator n.z + 1 cancels,
///      so z comes from x and y there: 2 z^2 = (x^2 + y^2) / (1 - n.z). At n = -z every half-way vector is right: +x.
template <class T>
Vec3<T> half_way_from_normal(const Vec3<T>& n) noexcept {
  const T side = n.x * n.x + n.y * n.y;
  const T twice_square = n.z < T(0) ? side / (T(1) - n.z) : T(1) + n.z;
  const T z = std::sqrt(twice_square / T(2));
  return normalised_or(Vec3<T>(n.x, n.y, T(2) * z * z), Vec3<T>(T(1), T(0), T(0)));
}

/// Normal between two half-way vectors.
/// eq   h = (1 - t) h0 + t h1;  N = 2 (h.z / h.h) h - z: the axis +z reflected about h   (Hast 2005, eq. 17, with the
///      last line read as N.z -= 1). Two opposite half-way vectors have no mean: then h = h0.
template <class T>
Vec3<T> normal_between(const Vec3<T>& h0, const Vec3<T>& h1, T t) noexcept {
  const Vec3<T> h = normalised_or(h0 * (T(1) - t) + h1 * t, h0);
  Vec3<T> n = h * (T(2) * h.z);
  n.z -= T(1);
  return n;
}

/// h or -h, whichever is nearer to `reference`: aligns the corners of a triangle with one of them, because h and -h
/// represent the same normal.
template <class T>
Vec3<T> half_way_aligned(const Vec3<T>& reference, const Vec3<T>& h) noexcept {
  return glm::dot(reference, h) < T(0) ? -h : h;
}

}  // namespace sinew::reference
