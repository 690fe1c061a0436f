// SPDX-License-Identifier: MIT
// Round trips: decomposing and recomposing gives the original.
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "runtime/math/axis_angle.h"
#include "runtime/math/decompose.h"
#include "runtime/math/euler.h"
#include "runtime/math/quat_log_exp.h"
#include "tests/math/random_motions.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using Q = Quat<double>;
using V = Vec3<double>;

double difference(const Q& a, const Q& b) { return safe_length(a - b); }

double distance(const Mat3<double>& a, const Mat3<double>& b) {
  return test::distance(affine_from(a, V(0)), affine_from(b, V(0)));
}

/// An exponent in (-3, 3), never near 0.
double exponent(std::uint32_t bits) { return static_cast<double>(bits % 600) / 100 - 2.995; }

RC_GTEST_PROP(log_and_exp, exp_undoes_log, (Q q)) { RC_ASSERT(difference(quat_exp(quat_log(q)), q) < 1e-14); }

RC_GTEST_PROP(log_and_exp, log_undoes_exp_within_half_a_turn, (V v)) {
  const V shorter = v * (3.1 / 4);  // |v| < 3.5 -> below pi
  RC_PRE(safe_length(shorter) < 3.1);
  RC_ASSERT(test::distance(quat_log(quat_exp(shorter)), shorter) < 1e-13);
}

RC_GTEST_PROP(log_and_exp, exp_of_parallel_vectors_multiplies, (V v, std::uint32_t bits)) {
  const double s = exponent(bits);
  RC_ASSERT(difference(quat_exp(v) * quat_exp(v * s), quat_exp(v * (1 + s))) < 1e-14);
}

RC_GTEST_PROP(log_and_exp, log_turns_with_its_rotation, (Q q, Q turn)) {
  const V turned = rotate_vector(turn, quat_log(q));
  RC_ASSERT(test::distance(quat_log(turn * q * quat_conjugate(turn)), turned) < 1e-12);
}

RC_GTEST_PROP(power, exponents_add_and_whole_ones_are_products, (Q q, std::uint32_t bits)) {
  const double s = exponent(bits);
  RC_ASSERT(difference(quat_pow(q, s) * quat_pow(q, 1.5), quat_pow(q, s + 1.5)) < 1e-13);
  RC_ASSERT(difference(quat_pow(q, 3.0), q * q * q) < 1e-14);
  RC_ASSERT(difference(quat_pow(q, -1.0), quat_conjugate(q)) < 1e-14);
  RC_ASSERT(difference(quat_pow(q, 0.0), quat_identity<double>()) == 0);
}

RC_GTEST_PROP(power, roots_raised_again_give_the_rotation, (Q q, std::uint32_t bits)) {
  const double n = 1 + bits % 9;
  RC_ASSERT(difference(quat_pow(quat_pow(q, 1 / n), n), q) < 2e-14);
}

RC_GTEST_PROP(axis_angle, round_trips_by_quaternion_and_matrix, (Q q)) {
  const auto a = axis_angle_from_quat(q);
  RC_ASSERT(test::angle_between(quat_from_axis_angle(a.axis, a.angle_rad), q) < 1e-14);
  RC_ASSERT(distance(matrix_from_axis_angle(a.axis, a.angle_rad), matrix_from_quat(q)) < 1e-14);
}

RC_GTEST_PROP(matrix_and_quaternion, N12_round_trip_from_either_side, (Q q)) {
  const Mat3<double> m = matrix_from_quat(q);
  RC_ASSERT(test::angle_between(quat_from_matrix(m), q) < 1e-15);
  RC_ASSERT(distance(matrix_from_quat(quat_from_matrix(m)), m) < 2e-15);
  RC_ASSERT(distance(matrix_from_quat(-q), m) == 0);
}

RC_GTEST_PROP(euler, N13_all_24_orders_rebuild_any_rotation, (Q q)) {
  const Mat3<double> m = matrix_from_quat(q);
  for (const EulerOrder& order : kEulerOrders)
    RC_ASSERT(distance(matrix_from_euler(order, euler_from_matrix(order, m)), m) < 4e-15);
}

RC_GTEST_PROP(euler, N13_all_24_orders_rebuild_at_their_gimbal_lock, (V angles, std::uint32_t bits)) {
  for (const EulerOrder& order : kEulerOrders) {
    const bool proper = order.axes[0] == order.axes[2];
    const double lock = proper ? (bits & 1 ? 0.0 : std::numbers::pi) : (bits & 1 ? 0.5 : -0.5) * std::numbers::pi;
    const double aside = std::pow(10.0, -static_cast<double>(bits % 17));  // 1 down to 1e-16
    const Mat3<double> m = matrix_from_euler(order, V(angles.x, lock + aside * angles.y * 0.1, angles.z));
    RC_ASSERT(distance(matrix_from_euler(order, euler_from_matrix(order, m)), m) < 4e-15);
  }
}

RC_GTEST_PROP(euler, angles_come_back_away_from_the_lock, (V angles)) {
  const V half = angles * 0.7;  // below 1.4, inside the principal range of orders without a repeated axis
  for (const EulerOrder& order : kEulerOrders) {
    if (order.axes[0] == order.axes[2]) continue;
    RC_ASSERT(test::distance(euler_from_matrix(order, matrix_from_euler(order, half)), half) < 1e-13);
  }
}

RC_GTEST_PROP(euler, head_pitch_roll_is_one_of_the_orders, (V angles)) {
  const HeadPitchRollT<double> e{angles.x, angles.y, angles.z};
  const Mat3<double> m = matrix_from_head_pitch_roll(e);
  RC_ASSERT(distance(matrix_from_quat(quat_from_head_pitch_roll(e)), m) < 2e-15);
  RC_ASSERT(distance(matrix_from_head_pitch_roll(head_pitch_roll_from_matrix(m)), m) < 4e-15);
  // eq. 4.21: E = Rz(roll) Rx(pitch) Ry(head), about fixed axes y, x, z
  RC_ASSERT(distance(matrix_from_euler(EulerOrder{{1, 0, 2}, true}, angles), m) < 2e-15);
}

RC_GTEST_PROP(decompose, N15_trs_gives_back_what_it_was_composed_of, (V t, Q q, V s, std::uint32_t bits)) {
  const double size = std::pow(10.0, static_cast<double>(bits % 25) - 12);  // scales down to 1e-12
  const V scale = (glm::abs(s) + V(0.1)) * size * V(bits & 64 ? -1 : 1, 1, 1);
  const auto found = decompose_trs(affine_from_transform(Transformd{t, q, scale}));
  RC_ASSERT(found.transform.translation == t);
  RC_ASSERT(test::angle_between(found.transform.rotation, q) < 1e-14);
  RC_ASSERT(test::distance(found.transform.scale, scale) < 1e-14 * size);
}

RC_GTEST_PROP(decompose, N16_polar_factors_give_back_any_matrix, (V x, V y, V z, std::uint32_t bits)) {
  Mat3<double> m(x, y, z);
  if (bits % 4 == 0) m[2] = m[0] * 0.3 - m[1];  // rank two
  if (bits % 8 == 0) m[1] = m[0] * 2.0;         // rank one
  const auto p = decompose_polar(m);
  RC_ASSERT(distance(p.rotation * matrix_from_stretch(p.stretch), m) < 1e-14);
  RC_ASSERT(distance(glm::transpose(p.rotation) * p.rotation, Mat3<double>(1)) < 1e-14);
  RC_ASSERT(glm::determinant(p.rotation) > 0);
}

RC_GTEST_PROP(decompose, N16_polar_rotation_turns_with_the_matrix, (V x, V y, V z, Q turn)) {
  const Mat3<double> m(x, y, z), r = matrix_from_quat(turn);
  const double volume = glm::determinant(m);
  RC_PRE(std::abs(volume) > 0.1);
  const auto plain = decompose_polar(m), turned = decompose_polar(r * m);
  RC_ASSERT(distance(turned.rotation, r * plain.rotation) < 1e-12);
  for (int i = 0; i < 6; ++i) RC_ASSERT(std::abs(turned.stretch[i] - plain.stretch[i]) < 1e-12);
}

}  // namespace
}  // namespace sinew
