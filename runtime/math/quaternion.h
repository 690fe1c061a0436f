// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "runtime/math/conventions.h"

namespace sinew {

/// Names differ from GLM's, since argument-dependent lookup finds those too and calls would be ambiguous. The product
/// is GLM's `a * b`: b is applied first (Real-Time Rendering 4th ed., eq. 4.28).

/// Identity rotation.
template <class T>
constexpr Quat<T> quat_identity() noexcept {
  return quat_xyzw(T(0), T(0), T(0), T(1));
}

/// 4D dot product: cosine of half the rotation angle between unit q and r, up to sign.
template <class T>
T quat_dot(const Quat<T>& q, const Quat<T>& r) noexcept {
  return (q.x * r.x + q.y * r.y) + (q.z * r.z + q.w * r.w);
}

/// Largest absolute value of the components. After division by it, squares neither overflow nor underflow. NaN
/// components may be ignored.
template <class T>
T largest_component(const Quat<T>& q) noexcept {
  return (std::max)((std::max)(std::abs(q.x), std::abs(q.y)), (std::max)(std::abs(q.z), std::abs(q.w)));
}

template <class T>
T largest_component(const Vec3<T>& v) noexcept {
  return (std::max)((std::max)(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
}

/// Sum of the squares of all components.
template <class V>
constexpr typename V::value_type square_of(const V& v) noexcept {
  auto sum = v[0] * v[0];
  for (int i = 1; i < V::length(); ++i) sum += v[i] * v[i];
  return sum;
}

/// True if a sum of squares lost no digits to underflow and is far from overflow.
template <class T>
constexpr bool is_safe_square(T sum) noexcept {
  return sum >= T(1e-20) && sum <= T(1e30);
}

/// Length of a Vec3 or Quat, without overflow or underflow of the squares. NaN if a component is NaN.
template <class V>
typename V::value_type safe_length(const V& v) noexcept {
  using T = typename V::value_type;
  const T plain = square_of(v);
  if (is_safe_square(plain)) return std::sqrt(plain);
  const T m = largest_component(v);
  const bool scalable = m > T(0) && std::isfinite(m);
  return scalable ? m * std::sqrt(square_of(v / m)) : std::sqrt(plain);
}

/// Unit vector or quaternion along v, or `fallback` where v has no direction (zero, infinite or NaN).
/// eq   v / |v|;  where |v|^2 would overflow or vanish, v is first divided by its largest component
template <class V>
V normalised_or(const V& v, const V& fallback) noexcept {
  using T = typename V::value_type;
  const T plain = square_of(v);
  if (is_safe_square(plain)) return v / std::sqrt(plain);
  const T m = largest_component(v);
  const V scaled = v / m;
  const T sum = square_of(scaled);
  return m > T(0) && is_safe_square(sum) ? scaled / std::sqrt(sum) : fallback;
}

/// Unit quaternion along q; the identity where q has no direction (zero, infinite or NaN).
template <class T>
Quat<T> normalised(const Quat<T>& q) noexcept {
  return normalised_or(q, quat_identity<T>());
}

/// Conjugate: the inverse of a unit quaternion.
/// eq   q* = (-v, w)   (Real-Time Rendering, eq. 4.31)
template <class T>
constexpr Quat<T> quat_conjugate(const Quat<T>& q) noexcept {
  return quat_xyzw(-q.x, -q.y, -q.z, q.w);
}

/// Inverse of a quaternion of any length.
/// eq   q^-1 = q* / |q|^2   (Real-Time Rendering, eq. 4.35); the identity where q has no direction
template <class T>
Quat<T> quat_inverse(const Quat<T>& q) noexcept {
  const T m = largest_component(q);
  const Quat<T> s = q / m;
  const T sum = quat_dot(s, s);
  return m > T(0) && sum >= T(1) && sum <= T(4) ? quat_conjugate(s) / sum / m : quat_identity<T>();
}

/// Hemisphere alignment: -q where q . reference < 0, else q.
template <class T>
Quat<T> aligned_with(const Quat<T>& reference, const Quat<T>& q) noexcept {
  return quat_dot(reference, q) < T(0) ? -q : q;
}

/// Rotates a vector by a unit quaternion.
/// eq   p' = q p q* = p + 2 w (v x p) + 2 v x (v x p)   for unit q   (Real-Time Rendering, eq. 4.36)
template <class T>
Vec3<T> rotate_vector(const Quat<T>& q, const Vec3<T>& p) noexcept {
  const Vec3<T> v(q.x, q.y, q.z);
  const Vec3<T> twice = glm::cross(v, p) * T(2);
  return p + twice * q.w + glm::cross(v, twice);
}

/// Rotation angle between q and r in [0, pi], signs ignored.
/// eq   2 atan2(|v|, |w|) of q* r: accurate for small angles, where acos resolves nothing below 3e-4
template <class T>
T rotation_angle_between(const Quat<T>& q, const Quat<T>& r) noexcept {
  const Quat<T> d = quat_conjugate(q) * r;
  return T(2) * std::atan2(safe_length(Vec3<T>(d.x, d.y, d.z)), std::abs(d.w));
}

template <class To, class From>
Quat<To> quat_cast(const Quat<From>& q) noexcept {
  return quat_xyzw(static_cast<To>(q.x), static_cast<To>(q.y), static_cast<To>(q.z), static_cast<To>(q.w));
}

}  // namespace sinew
