// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "importer/tool/cost/rotation/approximate_slerp.h"
#include "runtime/math/affine.h"
#include "runtime/math/dual_quaternion.h"
#include "runtime/math/interpolate.h"
#include "runtime/math/inverse.h"
#include "runtime/math/rotation_between.h"
#include "tests/math/random_motions.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using Q = Quat<double>;
using V = Vec3<double>;

double difference(const Q& a, const Q& b) { return safe_length(a - b); }

/// A parameter strictly between the keys.
double inner(std::uint32_t bits) { return (static_cast<double>(bits % 997) + 1) / 999; }

bool unique_arc(const Q& q, const Q& r) { return std::abs(quat_dot(q, r)) > 1e-6; }

RC_GTEST_PROP(quaternion_algebra, product_is_associative, (Q a, Q b, Q c)) {
  RC_ASSERT(difference((a * b) * c, a * (b * c)) < 1e-15 * 4);
}

RC_GTEST_PROP(quaternion_algebra, products_compose_rotations_as_matrices_do, (Q a, Q b, V p)) {
  const auto m = matrix_from_quat(a) * matrix_from_quat(b);
  RC_ASSERT(test::distance(rotate_vector(a * b, p), m * p) < 1e-14);
  RC_ASSERT(test::angle_between(quat_from_matrix(m), a * b) < 1e-14);
}

RC_GTEST_PROP(quaternion_algebra, inverse_undoes_at_any_length, (Q a, std::uint32_t bits)) {
  const Q q = a * std::pow(10.0, inner(bits) * 40 - 20);
  RC_ASSERT(difference(q * quat_inverse(q), quat_identity<double>()) < 1e-14);
}

RC_GTEST_PROP(quaternion_algebra, length_of_a_product_is_the_product_of_lengths, (Q a, Q b)) {
  RC_ASSERT(std::abs(safe_length(a * 3.0 * b) - 3.0) < 1e-14);
}

RC_GTEST_PROP(quaternion_algebra, conjugate_turns_products_round, (Q a, Q b)) {
  RC_ASSERT(difference(quat_conjugate(a * b), quat_conjugate(b) * quat_conjugate(a)) < 1e-15);
}

RC_GTEST_PROP(quaternion_algebra, q_and_minus_q_rotate_alike, (Q q, V p)) {
  RC_ASSERT(test::distance(rotate_vector(q, p), rotate_vector(-q, p)) == 0);
}

RC_GTEST_PROP(quaternion_algebra, rotation_keeps_lengths_and_products, (Q q, V a, V b)) {
  RC_ASSERT(std::abs(glm::dot(rotate_vector(q, a), rotate_vector(q, b)) - glm::dot(a, b)) < 4e-14);
  RC_ASSERT(test::distance(rotate_vector(q, glm::cross(a, b)), glm::cross(rotate_vector(q, a), rotate_vector(q, b))) <
            1e-13);
}

RC_GTEST_PROP(slerp, N02_signs_of_the_keys_do_not_matter, (Q q, Q r, std::uint32_t bits)) {
  RC_PRE(unique_arc(q, r));
  const double t = inner(bits);
  const Q plain = slerp_short_arc(q, r, t);
  RC_ASSERT(difference(slerp_short_arc(q, -r, t), plain) < 1e-15);
  RC_ASSERT(difference(slerp_short_arc(-q, r, t), -plain) < 1e-15);
  RC_ASSERT(test::angle_between(nlerp_short_arc(-q, r, t), nlerp_short_arc(q, r, t)) < 1e-15);
}

RC_GTEST_PROP(slerp, is_symmetric_in_its_ends, (Q q, Q r, std::uint32_t bits)) {
  RC_PRE(unique_arc(q, r));
  const double t = inner(bits);
  RC_ASSERT(test::angle_between(slerp_short_arc(q, r, t), slerp_short_arc(r, q, 1 - t)) < 1e-14);
}

RC_GTEST_PROP(slerp, runs_at_constant_speed, (Q q, Q r, std::uint32_t bits)) {
  const double t = inner(bits) * 0.9, whole = test::angle_between(q, r);
  RC_ASSERT(std::abs(test::angle_between(slerp_short_arc(q, r, t), slerp_short_arc(q, r, t + 0.1)) - 0.1 * whole) <
            1e-14);
}

RC_GTEST_PROP(slerp, commutes_with_a_rotation_from_either_side, (Q q, Q r, Q turn, std::uint32_t bits)) {
  RC_PRE(unique_arc(q, r));
  const double t = inner(bits);
  RC_ASSERT(test::angle_between(turn * slerp_short_arc(q, r, t), slerp_short_arc(turn * q, turn * r, t)) < 2e-14);
  RC_ASSERT(test::angle_between(slerp_short_arc(q, r, t) * turn, slerp_short_arc(q * turn, r * turn, t)) < 2e-14);
}

RC_GTEST_PROP(slerp, nlerp_and_polynomial_share_its_path, (Q q, Q r, std::uint32_t bits)) {
  RC_PRE(unique_arc(q, r));
  const double t = inner(bits), whole = test::angle_between(q, r);
  const Q n = nlerp_short_arc(q, r, t);
  RC_ASSERT(std::abs(test::angle_between(q, n) + test::angle_between(n, r) - whole) < 1e-7);
  RC_ASSERT(test::angle_between(cost::polynomial_slerp(q, r, t), slerp_short_arc(q, r, t)) < 1e-8);
}

RC_GTEST_PROP(slerp, is_the_power_form, (Q q, Q r, std::uint32_t bits)) {
  RC_PRE(unique_arc(q, r));
  const double t = inner(bits);
  const Q power = quat_pow(aligned_with(q, r) * quat_conjugate(q), t) * q;  // eq. 4.52
  RC_ASSERT(test::angle_between(power, slerp_short_arc(q, r, t)) < 1e-13);
}

RC_GTEST_PROP(squad_curve, is_unit_everywhere, (Q a, Q b, Q c, Q d, std::uint32_t bits)) {
  const Q b1 = aligned_with(a, b), c1 = aligned_with(b1, c), d1 = aligned_with(c1, d);
  RC_ASSERT(std::abs(safe_length(squad(b1, squad_control(a, b1, c1), squad_control(b1, c1, d1), c1, inner(bits))) - 1) <
            1e-14);
}

RC_GTEST_PROP(dual_quaternion_algebra, product_is_associative_and_moves_as_the_matrices_do, (Q a, V t, Q b, V u, V p)) {
  const auto x = dual_quat_from(a, t), y = dual_quat_from(b, u), z = dual_quat_from(a * b, u - t);
  RC_ASSERT(test::distance(affine_from_dual_quat((x * y) * z), affine_from_dual_quat(x * (y * z))) < 1e-13);
  RC_ASSERT(test::distance(affine_from_dual_quat(x * y), affine_from_dual_quat(x) * affine_from_dual_quat(y)) < 1e-13);
  RC_ASSERT(test::distance(transform_point(dual_quat_conjugate(x), transform_point(x, p)), p) < 1e-13);
}

RC_GTEST_PROP(dual_quaternion_algebra, normalising_makes_a_rigid_motion_of_any_sum, (Q a, V t, Q b, V u, V p, V r)) {
  RC_PRE(quat_dot(a, b) > 0.01);
  const auto x = dual_quat_from(a, t), y = dual_quat_from(b, u);
  const auto sum = normalised(DualQuatd{x.real + y.real, x.dual + y.dual});
  RC_ASSERT(std::abs(safe_length(sum.real) - 1) < 1e-15 && std::abs(quat_dot(sum.real, sum.dual)) < 1e-15);
  const double before = test::distance(p, r), after = test::distance(transform_point(sum, p), transform_point(sum, r));
  RC_ASSERT(std::abs(before - after) < 1e-13);
}

RC_GTEST_PROP(matrix_algebra, product_is_associative_and_determinants_multiply, (Q a, V t, Q b, V u, Q c, V s)) {
  const auto stretched = [](const Q& q, const V& v, const V& scale) {
    return affine_from_transform(Transformd{v, q, scale});
  };
  const Affined x = stretched(a, t, u), y = stretched(b, u, s), z = stretched(c, s, t);
  RC_ASSERT(test::distance((x * y) * z, x * (y * z)) < 1e-13);
  RC_ASSERT(std::abs(determinant(x * y) - determinant(x) * determinant(y)) < 1e-12);
}

RC_GTEST_PROP(matrix_algebra, inverses_by_structure_agree, (Q a, V t, V p)) {
  const Affined rigid = affine_from_transform(Transformd{t, a, V(1)});
  RC_ASSERT(test::distance(inverse_rigid(rigid), *inverse_of(rigid)) < 1e-14);
  RC_ASSERT(test::distance(transform_point(inverse_rigid(rigid), transform_point(rigid, p)), p) < 1e-14);
}

RC_GTEST_PROP(rotation_between_vectors, back_is_the_inverse, (V s, V t)) {
  RC_PRE(safe_length(s) > 1e-3 && safe_length(t) > 1e-3);
  RC_PRE(safe_length(glm::cross(s, t)) > 1e-6 || glm::dot(s, t) > 0);
  RC_ASSERT(test::angle_between(rotation_between(s, t), quat_conjugate(rotation_between(t, s))) < 1e-9);
}

}  // namespace
}  // namespace sinew
