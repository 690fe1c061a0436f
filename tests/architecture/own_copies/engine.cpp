// SPDX-License-Identifier: MIT
// A file of an engine that uses the library's inline functions. The program is built twice: with normal flags for this
// file, and with fused multiply-add, -ffast-math and no inlining.
// In the second build this object holds its own copy of every function below and of the GLM functions they call. The
// linker meets this object first.
#include <glm/gtc/quaternion.hpp>

#include "runtime/animation/track_sample.h"
#include "runtime/math/decompose.h"
#include "runtime/math/dual_quaternion.h"
#include "runtime/math/euler.h"
#include "runtime/math/inverse.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/math/normal_transform.h"
#include "runtime/math/rotation_between.h"
#include "runtime/math/swing_twist.h"

namespace sinew::test {
namespace {

template <class T>
T use(const Quat<T>& q, const Quat<T>& r, const Vec3<T>& v, T t) noexcept {
  const Mat3<T> m = matrix_from_quat(q) * matrix_from_unit_quat(r) * rotation_about_axis(1, t);
  const DualQuatT<T> moved = normalised(dual_quat_from(q, v) * dual_quat_conjugate(dual_quat_from(r, v)));
  const Quat<T> turned = quat_exp(quat_log(q * r)) * quat_from_matrix(m) * slerp_as_given(q, r, t);
  const Vec3<T> normal = transform_normal_outward(m, v) + transform_normal(m, perpendicular_to(v)) +
                         rotate_vector(turned, normalised_or(v, v)) + transform_point(moved, v);
  const AffineT<T> placed = affine_from_transform(TransformT<T>{v, q, v}) * affine_from_dual_quat(moved);
  const AffineT<T> back = inverse_of(placed).value_or(inverse_rigid(placed));
  return swing_angle_between(q, r, v) + twist_angle_between(q, r, v) + safe_length(normal) +
         safe_length(transform_point(back, v)) + glm::dot(slerp_short_arc(q, r, t), nlerp_short_arc(q, r, t)) +
         glm::length(glm::eulerAngles(turned)) + glm::determinant(glm::inverse(m));
}

template <class T>
T use(const QuatTrack& rotations, const Vec3Track& vectors, const WeightTrack& weights, double time_s) noexcept {
  T sampled[4] = {};
  sample_track<T>(weights, time_s, std::span<T>(sampled, weights.target_count));
  const Quat<T> q = sample_track<T>(rotations, time_s);
  return use(q, sample_track<T>(rotations, time_s / 2), sample_track<T>(vectors, time_s), sampled[0]);
}

}  // namespace

double use_inline_functions(const QuatTrack& rotations, const Vec3Track& vectors, const WeightTrack& weights,
                            double time_s) noexcept {
  return use<double>(rotations, vectors, weights, time_s) +
         static_cast<double>(use<float>(rotations, vectors, weights, time_s));
}

}  // namespace sinew::test
