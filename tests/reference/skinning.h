// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/math/dual_quaternion.h"
#include "runtime/math/normal_transform.h"

namespace sinew::reference {

/// Skinning of one vertex straight from the equations. With T = double it is the truth that tests hold the jobs to. T =
/// float shows how close careful single precision can get. Weights may have any positive sum: the functions divide by
/// it.

template <class T>
T weight_sum(std::span<const T> weights) {
  T sum = T(0);
  for (const T w : weights) sum += w;
  return sum;
}

/// eq   M = sum(w M_i) / sum(w)   (Real-Time Rendering, eq. 4.59)
template <class T>
AffineT<T> blend_matrices(std::span<const AffineT<T>> matrices, std::span<const T> weights) {
  AffineT<T> sum{{Vec4<T>(T(0)), Vec4<T>(T(0)), Vec4<T>(T(0))}};
  for (std::size_t i = 0; i < matrices.size(); ++i)
    for (int r = 0; r < 3; ++r) sum.row[r] += matrices[i].row[r] * weights[i];
  const T total = weight_sum(weights);
  for (auto& row : sum.row) row /= total;
  return sum;
}

/// eq   p' = M p with the blended matrix
template <class T>
Vec3<T> skin_linear(std::span<const AffineT<T>> matrices, std::span<const T> weights, const Vec3<T>& p) {
  return transform_point(blend_matrices(matrices, weights), p);
}

/// The influence whose sign the others are aligned with: the largest weight, the lowest index on ties.
template <class T>
std::size_t pivot_of(std::span<const T> weights) {
  std::size_t pivot = 0;
  for (std::size_t i = 1; i < weights.size(); ++i)
    if (weights[i] > weights[pivot]) pivot = i;
  return pivot;
}

/// A rigid motion blended from several. `length`: of its real part before normalising, for weights of sum 1.
template <class T>
struct BlendT {
  DualQuatT<T> motion;
  T length = T(1);
};

/// Weighted mean of rigid motions. Where the real part cancels (squared length below 1e-12), the result follows the
/// pivot. Positive weights never cancel.
/// eq   d = sum(w sign(r_i . r_pivot) d_i), divided by the length of its real part; sign(0) = +1   (Kavan et al. 2008)
template <class T>
BlendT<T> blend_motions(std::span<const DualQuatT<T>> motions, std::span<const T> weights) {
  const DualQuatT<T>& pivot = motions[pivot_of(weights)];
  const Quat<T> zero = quat_xyzw(T(0), T(0), T(0), T(0));
  DualQuatT<T> sum{zero, zero};
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const T w = quat_dot(pivot.real, motions[i].real) < T(0) ? -weights[i] : weights[i];
    sum.real = sum.real + motions[i].real * w;
    sum.dual = sum.dual + motions[i].dual * w;
  }
  const T total = weight_sum(weights), length = std::sqrt(quat_dot(sum.real, sum.real));
  if (!(length * length > T(1e-12) * total * total)) return {normalised(pivot), T(0)};
  return {{sum.real / length, sum.dual / length}, length / total};
}

/// eq   S = sum(w S_i) / sum(w): phase one of dual-quaternion skinning, stretch in bind space
template <class T>
Mat3<T> blend_stretches(std::span<const Mat3<T>> stretches, std::span<const T> weights) {
  Mat3<T> sum(T(0));
  for (std::size_t i = 0; i < stretches.size(); ++i) sum += stretches[i] * weights[i];
  return sum / weight_sum(weights);
}

template <class T>
struct SkinnedT {
  Vec3<T> position, normal;
  Quat<T> rotation;  ///< rotation of the blended dual quaternion
};

/// eq   p1 = S p;  p' = d p1 d*;  n' = rotate(d, normalise(sign(det S) cof(S) n))   with the blended S and d
/// in   stretches  empty = no joint stretches
template <class T>
SkinnedT<T> skin_dual_quaternion(std::span<const DualQuatT<T>> motions, std::span<const Mat3<T>> stretches,
                                 std::span<const T> weights, const Vec3<T>& p, const Vec3<T>& n) {
  const DualQuatT<T> motion = blend_motions(motions, weights).motion;
  if (stretches.empty()) return {transform_point(motion, p), transform_vector(motion, n), motion.real};
  const Mat3<T> stretch = blend_stretches(stretches, weights);
  return {transform_point(motion, stretch * p), transform_vector(motion, transform_normal_outward(stretch, n)),
          motion.real};
}

/// eq   p' = R S (p - c) + M c: R the rotation of the blended motions, M the blended matrix, c the vertex's center of
///      rotation (Le and Hodgins 2016, algorithm 1); S the blended stretch, so that one joint alone gives its matrix
/// in   stretches  empty = no joint stretches
template <class T>
SkinnedT<T> skin_center_of_rotation(std::span<const DualQuatT<T>> motions, std::span<const AffineT<T>> matrices,
                                    std::span<const T> weights, const Vec3<T>& p, const Vec3<T>& n,
                                    const Vec3<T>& center, std::span<const Mat3<T>> stretches = {}) {
  const Quat<T> rotation = blend_motions(motions, weights).motion.real;
  const Vec3<T> moved = skin_linear(matrices, weights, center);
  if (stretches.empty()) return {rotate_vector(rotation, p - center) + moved, rotate_vector(rotation, n), rotation};
  const Mat3<T> stretch = blend_stretches(stretches, weights);
  return {rotate_vector(rotation, stretch * (p - center)) + moved,
          rotate_vector(rotation, transform_normal_outward(stretch, n)), rotation};
}

}  // namespace sinew::reference
