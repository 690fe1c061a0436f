// SPDX-License-Identifier: MIT
#include "runtime/math/euler.h"

#include "runtime/math/rotation_about.h"

namespace sinew {
namespace {

template <class T>
Mat3<T> matrix_of(const HeadPitchRollT<T>& e) noexcept {
  const T ch = std::cos(e.head_rad), sh = std::sin(e.head_rad);
  const T cp = std::cos(e.pitch_rad), sp = std::sin(e.pitch_rad);
  const T cr = std::cos(e.roll_rad), sr = std::sin(e.roll_rad);
  const Vec3<T> x(cr * ch - sr * sp * sh, sr * ch + cr * sp * sh, -cp * sh);
  const Vec3<T> y(-sr * cp, cr * cp, sp);
  const Vec3<T> z(cr * sh + sr * sp * ch, sr * sh - cr * sp * ch, cp * ch);
  return {x, y, z};
}

template <class T>
Quat<T> quat_of(const HeadPitchRollT<T>& e) noexcept {
  const T h = e.head_rad / 2, p = e.pitch_rad / 2, r = e.roll_rad / 2;
  const T zero = T(0);
  return quat_xyzw(zero, zero, std::sin(r), std::cos(r)) * quat_xyzw(std::sin(p), zero, zero, std::cos(p)) *
         quat_xyzw(zero, std::sin(h), zero, std::cos(h));
}

template <class T>
HeadPitchRollT<T> head_pitch_roll_of(const Mat3<T>& m) noexcept {
  const T roll = std::atan2(-m[1][0], m[1][1]);
  const T c = std::cos(roll), s = std::sin(roll);
  return {std::atan2(c * m[2][0] + s * m[2][1], c * m[0][0] + s * m[0][1]),
          std::atan2(m[1][2], c * m[1][1] - s * m[1][0]), roll};
}

template <class T>
Mat3<T> matrix_of(const EulerOrder& order, const Vec3<T>& angles_rad) noexcept {
  const Mat3<T> first = rotation_about_axis(order.axes[0], angles_rad.x);
  const Mat3<T> second = rotation_about_axis(order.axes[1], angles_rad.y);
  const Mat3<T> third = rotation_about_axis(order.axes[2], angles_rad.z);
  return order.fixed ? third * second * first : first * second * third;
}

/// R = Ra(outer) Rb(middle) Rc(inner). The outer angle comes first, from the column that Rc leaves unchanged. Once it
/// is taken out of the matrix, the middle and inner angles follow without a division.
template <class T>
Vec3<T> euler_of(const EulerOrder& order, const Mat3<T>& m) noexcept {
  const int a = order.fixed ? order.axes[2] : order.axes[0], b = order.axes[1];
  const int c = order.fixed ? order.axes[0] : order.axes[2];
  const bool repeated = a == c;
  const int other = 3 - a - b;                     // the axis that is neither outer nor middle
  const T even = (a + 1) % 3 == b ? T(1) : T(-1);  // (a, b, other) cyclic or not
  // Column c of R is Ra Rb e_c; without repetition e_c = e_other, Rb e_other = cos e_other + even sin e_a.
  const T along_b = m[c][b], along_other = m[c][other];
  const T outer = repeated ? std::atan2(along_b, -even * along_other) : std::atan2(-even * along_b, along_other);
  const Mat3<T> rest = rotation_about_axis(a, -outer) * m;  // Rb(middle) Rc(inner)
  const T middle =
      repeated ? std::atan2(-even * rest[c][other], rest[c][a]) : std::atan2(even * rest[c][a], rest[c][other]);
  // Row b of Rb Rc is row b of Rc: the middle rotation leaves it unchanged.
  const int next = repeated ? other : a;              // the axis that Rc mixes with b
  const T sign = (c + 1) % 3 == next ? T(1) : T(-1);  // Rc e_next = cos e_next + sign sin e_b
  const T inner = std::atan2(sign * rest[next][b], rest[b][b]);
  return order.fixed ? Vec3<T>(inner, middle, outer) : Vec3<T>(outer, middle, inner);
}

}  // namespace

template <>
Mat3<float> matrix_from_head_pitch_roll(const HeadPitchRollT<float>& e) noexcept {
  return matrix_of(e);
}

template <>
Quat<float> quat_from_head_pitch_roll(const HeadPitchRollT<float>& e) noexcept {
  return quat_of(e);
}

template <>
HeadPitchRollT<float> head_pitch_roll_from_matrix(const Mat3<float>& m) noexcept {
  return head_pitch_roll_of(m);
}

template <>
Mat3<float> matrix_from_euler(const EulerOrder& order, const Vec3<float>& angles_rad) noexcept {
  return matrix_of(order, angles_rad);
}

template <>
Vec3<float> euler_from_matrix(const EulerOrder& order, const Mat3<float>& m) noexcept {
  return euler_of(order, m);
}

template <>
Mat3<double> matrix_from_head_pitch_roll(const HeadPitchRollT<double>& e) noexcept {
  return matrix_of(e);
}

template <>
Quat<double> quat_from_head_pitch_roll(const HeadPitchRollT<double>& e) noexcept {
  return quat_of(e);
}

template <>
HeadPitchRollT<double> head_pitch_roll_from_matrix(const Mat3<double>& m) noexcept {
  return head_pitch_roll_of(m);
}

template <>
Mat3<double> matrix_from_euler(const EulerOrder& order, const Vec3<double>& angles_rad) noexcept {
  return matrix_of(order, angles_rad);
}

template <>
Vec3<double> euler_from_matrix(const EulerOrder& order, const Mat3<double>& m) noexcept {
  return euler_of(order, m);
}

}  // namespace sinew
