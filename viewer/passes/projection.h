// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "runtime/math/conventions.h"

namespace sinew::viewer {

// Projection matrices, from view space to clip space. frame_uniforms.cpp uses them with reversed depth. tests/math
// checks every depth mapping and both handednesses.

/// The stored depth after the division by w.
enum class DepthMapping {
  gl,        ///< -1 at near, +1 at far
  zero_one,  ///< 0 at near, 1 at far
  reversed,  ///< 1 at near, 0 at far: with float depth the resolution is nearly even
};

/// A frustum: the edges of its rectangle in the near plane and the near distance, in metres.
template <class T>
struct FrustumT {
  T left, right, bottom, top, near_m;
};

/// eq   top = near tan(fov / 2), right = aspect top
template <class T>
FrustumT<T> symmetric_frustum(T fov_y_rad, T aspect, T near_m) noexcept {
  const T top = near_m * std::tan(fov_y_rad / T(2)), right = top * aspect;
  return {-right, right, -top, top, near_m};
}

/// A perspective matrix without its depth row: x, y, and w = distance in front of the eye.
/// in   facing  -1: the eye looks along -z (right-handed); +1: along +z (left-handed)
template <class T>
Mat4<T> perspective_frame(const FrustumT<T>& f, T facing) noexcept {
  const T width = f.right - f.left, height = f.top - f.bottom;
  Mat4<T> m(T(0));
  m[0][0] = T(2) * (f.near_m / width);
  m[1][1] = T(2) * (f.near_m / height);
  m[2][0] = -facing * ((f.right + f.left) / width);
  m[2][1] = -facing * ((f.top + f.bottom) / height);
  m[2][3] = facing;
  return m;
}

/// Perspective matrix without its depth row for a symmetric frustum, computed from the angle, so that no length can
/// overflow.
/// eq   y scale = 1 / tan(fov / 2), x scale = y scale / aspect   (Real-Time Rendering, eq. 4.75)
template <class T>
Mat4<T> perspective_frame(T fov_y_rad, T aspect, T facing) noexcept {
  const T scale = T(1) / std::tan(fov_y_rad / T(2));
  Mat4<T> m(T(0));
  m[0][0] = scale / aspect;
  m[1][1] = scale;
  m[2][3] = facing;
  return m;
}

/// Adds the depth row to a perspective frame: depth = A + B / distance. A and B are computed without the product of
/// near and far, which could overflow.
/// eq   gl A = (f + n) / (f - n), B = -2 n f / (f - n)   (Real-Time Rendering, eqs. 4.74-4.76); [0,1] A = f / (f - n),
///      B = -n f / (f - n);  reversed A = -n / (f - n), B = n f / (f - n)
template <class T>
Mat4<T> with_depth(Mat4<T> frame, DepthMapping mapping, T near_m, T far_m) noexcept {
  const T facing = frame[2][3], length = far_m - near_m;
  const T n = near_m / length, f = far_m / length;
  const bool gl = mapping == DepthMapping::gl, forward = mapping == DepthMapping::zero_one;
  const T a = gl ? (far_m + near_m) / length : (forward ? f : -n);
  const T b = gl ? -T(2) * f * near_m : (forward ? -f * near_m : f * near_m);
  frame[2][2] = facing * a;
  frame[3][2] = b;
  return frame;
}

/// The limit of with_depth for far to infinity   (Real-Time Rendering, eq. 4.73)
template <class T>
Mat4<T> with_infinite_depth(Mat4<T> frame, DepthMapping mapping, T near_m) noexcept {
  const bool gl = mapping == DepthMapping::gl, forward = mapping == DepthMapping::zero_one;
  const T facing = frame[2][3];
  frame[2][2] = gl || forward ? facing : T(0);
  frame[3][2] = gl ? -T(2) * near_m : (forward ? -near_m : near_m);
  return frame;
}

/// A box of view space. Near and far are signed z: 0 > near > far for an eye that looks along -z.
template <class T>
struct ViewBoxT {
  T left, right, bottom, top, near_z, far_z;
};

/// An orthographic projection.
/// eq   x, y to [-1, 1] (Real-Time Rendering, eq. 4.63); z of near and far to the ends of the range (gl 4.63, [0,1]
///      4.66)
template <class T>
Mat4<T> orthographic(const ViewBoxT<T>& b, DepthMapping mapping) noexcept {
  const T width = b.right - b.left, height = b.top - b.bottom, depth = b.far_z - b.near_z;
  Mat4<T> m(T(1));
  m[0][0] = T(2) / width;
  m[1][1] = T(2) / height;
  m[3][0] = -(b.right + b.left) / width;
  m[3][1] = -(b.top + b.bottom) / height;
  switch (mapping) {
    case DepthMapping::gl:
      m[2][2] = T(2) / depth;
      m[3][2] = -(b.far_z + b.near_z) / depth;
      break;
    case DepthMapping::zero_one:
      m[2][2] = T(1) / depth;
      m[3][2] = -b.near_z / depth;
      break;
    case DepthMapping::reversed:
      m[2][2] = -T(1) / depth;
      m[3][2] = b.far_z / depth;
      break;
  }
  return m;
}

}  // namespace sinew::viewer
