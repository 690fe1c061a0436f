// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/api.h"
#include "runtime/math/matrix_rotation.h"

namespace sinew {

/// Euler transform of Real-Time Rendering: head about y, then pitch about x, then roll about z.
template <class T>
struct HeadPitchRollT {
  T head_rad = T(0), pitch_rad = T(0), roll_rad = T(0);
};

/// Rotation matrix of a head, pitch and roll.
/// eq   E(h, p, r) = Rz(r) Rx(p) Ry(h)   (Real-Time Rendering, eqs. 4.21-4.23)
template <class T>
Mat3<T> matrix_from_head_pitch_roll(const HeadPitchRollT<T>& e) noexcept;

/// The same rotation, as a product of three quaternions.
template <class T>
Quat<T> quat_from_head_pitch_roll(const HeadPitchRollT<T>& e) noexcept;

/// Angles that rebuild the matrix, also at gimbal lock. There many triples of angles give one rotation: never compare
/// angles, compare rotations.
/// eq   r = atan2(-e01, e11);  h and p from Rz(-r) E, the matrix without roll:
///      h = atan2(c e02 + s e12, c e00 + s e10), p = atan2(e21, c e11 - s e01), c = cos r, s = sin r
///      (Real-Time Rendering, eqs. 4.24-4.26, but without the arcsine, which loses half the digits near gimbal lock)
/// in   m  a rotation up to rounding
template <class T>
HeadPitchRollT<T> head_pitch_roll_from_matrix(const Mat3<T>& m) noexcept;

/// Order of three rotations about coordinate axes. `axes` are 0..2 for x y z, the first is applied first, and
/// neighbours differ. `fixed`: about fixed axes (R = R3 R2 R1); otherwise about axes that move with the body (R = R1
/// R2 R3). 12 sequences of axes times 2 frames are the 24 orders of Shoemake.
struct EulerOrder {
  std::uint8_t axes[3] = {0, 1, 2};
  bool fixed = true;
};

/// All 24 orders.
inline constexpr EulerOrder kEulerOrders[24] = {
    {{0, 1, 2}, true},  {{0, 2, 1}, true},  {{1, 0, 2}, true},  {{1, 2, 0}, true},  {{2, 0, 1}, true},
    {{2, 1, 0}, true},  {{0, 1, 0}, true},  {{0, 2, 0}, true},  {{1, 0, 1}, true},  {{1, 2, 1}, true},
    {{2, 0, 2}, true},  {{2, 1, 2}, true},  {{0, 1, 2}, false}, {{0, 2, 1}, false}, {{1, 0, 2}, false},
    {{1, 2, 0}, false}, {{2, 0, 1}, false}, {{2, 1, 0}, false}, {{0, 1, 0}, false}, {{0, 2, 0}, false},
    {{1, 0, 1}, false}, {{1, 2, 1}, false}, {{2, 0, 2}, false}, {{2, 1, 2}, false}};

/// Rotation matrix of three angles.
/// eq   R3 R2 R1 (fixed) or R1 R2 R3 (moving); angles in the order of the axes   (Shoemake, Graphics Gems IV, III.5)
template <class T>
Mat3<T> matrix_from_euler(const EulerOrder& order, const Vec3<T>& angles_rad) noexcept;

/// Angles that rebuild the matrix in the given order. Gimbal lock is a middle angle of +-pi/2, or of 0 or pi with a
/// repeated axis. There only the sum or the difference of the outer and the inner angle is determined, and it may be
/// split in any way.
template <class T>
Vec3<T> euler_from_matrix(const EulerOrder& order, const Mat3<T>& m) noexcept;

template <>
SINEW_API Mat3<float> matrix_from_head_pitch_roll(const HeadPitchRollT<float>&) noexcept;
template <>
SINEW_API Mat3<double> matrix_from_head_pitch_roll(const HeadPitchRollT<double>&) noexcept;
template <>
SINEW_API Quat<float> quat_from_head_pitch_roll(const HeadPitchRollT<float>&) noexcept;
template <>
SINEW_API Quat<double> quat_from_head_pitch_roll(const HeadPitchRollT<double>&) noexcept;
template <>
SINEW_API HeadPitchRollT<float> head_pitch_roll_from_matrix(const Mat3<float>&) noexcept;
template <>
SINEW_API HeadPitchRollT<double> head_pitch_roll_from_matrix(const Mat3<double>&) noexcept;
template <>
SINEW_API Mat3<float> matrix_from_euler(const EulerOrder&, const Vec3<float>&) noexcept;
template <>
SINEW_API Mat3<double> matrix_from_euler(const EulerOrder&, const Vec3<double>&) noexcept;
template <>
SINEW_API Vec3<float> euler_from_matrix(const EulerOrder&, const Mat3<float>&) noexcept;
template <>
SINEW_API Vec3<double> euler_from_matrix(const EulerOrder&, const Mat3<double>&) noexcept;

}  // namespace sinew
